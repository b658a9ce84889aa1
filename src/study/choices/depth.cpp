#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <memory>

#include "base/check.h"
#include "base/counted.h"
#include "base/processor_time.h"
#include "study/accuracy/accuracy.h"
#include "study/plots/palette.h"
#include "study/rooms/pixel_map.h"

namespace flatray::depth_choice {
namespace {

using Kind = PixelOutcome::Kind;

constexpr int kSide = 128;  // pixels of the longer side of the film, an orbit each
constexpr std::uint64_t kTruthBounces = 4096, kLeastBounces = 64, kMostBounces = 1024;

// The room on a small film, and where its orbits end.
struct Fates {
  Fates(const Scene& whole, std::uint64_t of_seed) : scene(whole), seed(of_seed) {
    shrink(scene.film, kSide);
    room.emplace(scene);
  }
  Scene scene;
  std::uint64_t seed;
  std::optional<Room> room;
  std::vector<PixelOutcome> truth, found;
};

// From anywhere in each pixel: their centres may lie on a few orbits together.
std::vector<PixelOutcome> followed(const Fates& fates, std::uint64_t bounces, unsigned threads) {
  const Film& film = fates.scene.film;
  const ExperimentContext context{.scene = fates.scene, .threads = threads};
  const PlaceStarts starts(context, *fates.room, PixelMap::position);
  const std::uint64_t count = pixel_count(film);
  auto pixels = trace_outcomes(
      context, *fates.room, bounces, count, count,
      [&](std::uint64_t pixel) { return starts[drawn_in_pixel(film, pixel, fates.seed)]; });
  FLATRAY_CHECK(pixels.has_value());  // nothing stops it
  return std::move(*pixels);
}

// Hue by where an orbit ends, the darker the later; white where that is not known.
Image picture(const Fates& fates) {
  const Film& film = fates.scene.film;
  return image_of(film.width, film.height, [&](std::size_t i) {
    const PixelOutcome& pixel = fates.found[i];
    if (pixel.kind == Kind::limit) return LinearRgb{1, 1, 1};
    if (pixel.kind == Kind::solid) return LinearRgb{0.02, 0.02, 0.025};
    return (pixel.kind == Kind::escape ? hue_of(pixel.out) : nth_colour(pixel.surface)) *
           (1 / (1 + 0.15 * pixel.bounces));
  });
}

// The share of starts whose end is not known, of those whose end there is.
Outcome judge(const Fates& fates) {
  double open = 0, free = 0;
  for (std::size_t i = 0; i < fates.truth.size(); ++i) {
    if (fates.truth[i].kind == Kind::solid || fates.truth[i].kind == Kind::limit) continue;
    ++free;
    if (fates.found[i].kind != fates.truth[i].kind) ++open;
  }
  const auto [share, half] = share_of(open, free);
  return {share, half, picture(fates), {half, share, std::nullopt, std::nullopt}};
}

// Bounces of the longest orbit that ends.
std::uint64_t longest(const std::vector<PixelOutcome>& pixels) {
  std::uint64_t most = 0;
  for (const PixelOutcome& pixel : pixels)
    if (pixel.kind != Kind::limit) most = std::max<std::uint64_t>(most, pixel.bounces);
  return most;
}

Setting limited(const std::shared_ptr<Fates>& fates, std::uint64_t bounces, unsigned threads) {
  return {counted(bounces, "bounce"), static_cast<double>(bounces),
          [=] { fates->found = followed(*fates, bounces, threads); },
          [fates] { return judge(*fates); }};
}

std::string left_out(const Scene& scene) {
  if (scene.field() != 0) return kRaysAreBent;
  if (scene.rays.empty()) return "the scene has no rays";
  const Room room(scene);
  if (const auto met = expect_walls({.scene = scene}, room); !met)
    return met.error().front().message;
  return expect_closed({.scene = scene})
             ? "nothing leaves a closed room of mirrors: its orbits go on for ever"
             : "";
}

// As many bounces as there is time for: 4096 take no more than 64 times as long as 64, and mostly
// less, as most orbits have ended before.
std::uint64_t find_truth(Fates& fates, unsigned threads, double seconds) {
  const double start = processor_seconds();
  std::uint64_t bounces = kLeastBounces;
  for (;; bounces *= 8) {
    fates.truth = followed(fates, bounces, threads);
    if (bounces >= kTruthBounces || 8 * (processor_seconds() - start) > seconds) return bounces;
  }
}

Result<ChoiceSettings> settings(const AccuracyContext& context) {
  const auto fates = std::make_shared<Fates>(context.scene, context.seed);
  const std::uint64_t bounces = find_truth(*fates, context.threads, reference_budget(context));
  const auto stay = std::ranges::count(fates->truth, Kind::limit, &PixelOutcome::kind);
  const auto solid = std::ranges::count(fates->truth, Kind::solid, &PixelOutcome::kind);
  const auto count = static_cast<std::ptrdiff_t>(fates->truth.size()) - solid;
  if (stay == count)
    return fail(context.scene.where,
                fmt::format("none of {} orbits ends within {} bounces", count, bounces));
  ChoiceSettings made;
  made.unit = "share of the orbits that end whose end is not reached";
  made.reference = fmt::format(
      "{} orbits, one from anywhere in each pixel, followed for {} bounces, in which {} of them do "
      "not end and are left out",
      count, bounces, stay);
  if (bounces < kTruthBounces)
    made.cut = fmt::format("reference of {} bounces instead of {}", bounces, kTruthBounces);
  made.grows = "bounces";
  made.laws =
      {};  // orbits of most rooms have ended before either law, e^-n or a power, can be told
  // 1, 2, 3, 4, 6, 8, 12, ... until all have ended
  const std::uint64_t most =
      std::min({bounces / 4, kMostBounces, std::bit_ceil(longest(fates->truth) + 1)});
  for (std::uint64_t n = 1; n <= most; n += std::max<std::uint64_t>(1, std::bit_floor(n) / 2))
    made.settings.push_back(limited(fates, n, context.threads));
  return made;
}

}  // namespace

extern const Choice entry = {"depth", "After how many bounces is it known where orbits end?",
                             ErrorKind::truncation, &left_out, &settings};

}  // namespace flatray::depth_choice
