#include "render/light_picture.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "base/check.h"
#include "base/light.h"
#include "base/portable_math.h"
#include "render/film_transform.h"
#include "scene/lamp.h"

namespace flatray {
namespace {

const Scatterer* scatterer_of(const Scene& scene, const SurfaceOwner& owner) {
  using Kind = SurfaceOwner::Kind;
  const ScattererId id = owner.kind == Kind::entity ? scene.entities[owner.index].scatterer
                         : owner.kind == Kind::chamber
                             ? scene.chambers[owner.index].scatterer
                             : scene.chambers[owner.index].pillars[owner.pillar].scatterer;
  return id == kNoEntry ? nullptr : scene.scatterers[id].get();
}

// What is needed to follow light in a frame.
struct LitFrame {
  std::vector<World> worlds;  // one, or those of alternatives
  std::vector<const Scatterer*> scatterers;
  std::vector<LampState> lamps;
  FilmPlace place{};

  LitFrame(const Scene& scene, const FrameState& state)
      : worlds(alternative_worlds(scene, state)), lamps(lamp_states(scene, state)) {
    for (const SurfaceOwner& owner : worlds.front().owners)
      scatterers.push_back(scatterer_of(scene, owner));
    const FilmTransform film(scene.film, state);
    place = {film.corner().x(), film.corner().y(), film.scale(), scene.film.width,
             scene.film.height};
  }
};

unsigned noise_frame(const Scene& scene, const FrameState& state) {
  return scene.light.noise_moves ? state.frame : 0;
}

// Where less than this part of the walls is shown, pixels reach lamps sooner than lamps pixels
// (docs/adr/0023-light-from-lamps.md).
constexpr double kSmallPart = 2500;

double luminance_of(const double* rgb) { return luminance({rgb[0], rgb[1], rgb[2]}); }

}  // namespace

double automatic_exposure(std::span<const double> fluence) {
  std::vector<double> lit;
  for (std::size_t i = 0; i + 2 < fluence.size(); i += 3)
    if (const double y = luminance_of(&fluence[i]); y > 0) lit.push_back(y);
  if (lit.empty()) return 1;
  const auto place = lit.begin() + static_cast<std::ptrdiff_t>(lit.size() - 1 - lit.size() / 100);
  std::nth_element(lit.begin(), place, lit.end());
  return 1 / *place;
}

float toned(ToneCurve curve, double light) {
  constexpr double kMost = 1e6;  // far beyond white
  const double x = std::min(light, kMost);
  switch (curve) {
    case ToneCurve::linear:
    case ToneCurve::gamma:  // GammaCurve
      return static_cast<float>(x);
    case ToneCurve::soft:  // Reinhard et al. 2002, white at 4
      return static_cast<float>(std::min(x * (1 + x / 16) / (1 + x), 1.0));
    case ToneCurve::filmic:  // as fitted by Narkowicz 2015
      return static_cast<float>(
          std::min(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 1.0));
  }
  unreachable();
}

GammaCurve::GammaCurve(double gamma) {
  for (std::uint32_t i = 0; i < shown_.size(); ++i) {
    const auto light = static_cast<double>(std::bit_cast<float>((i + kFirst) << kShift));
    shown_[i] = static_cast<float>(light_of(255 * portable::pow(light, 1 / gamma)));
  }
}

float GammaCurve::operator()(double light) const {
  const auto x = static_cast<float>(light);
  if (!(x < 1)) return 1;
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(x), knot = bits >> kShift;
  if (x < 0 || knot < kFirst) return 0;
  const float part = static_cast<float>(bits & kRest) / static_cast<float>(kRest + 1);
  const float low = shown_[knot - kFirst];
  return low + part * (shown_[knot - kFirst + 1] - low);
}

LightPicture light_picture(std::span<const double> counts, double unit, const LightSettings& light,
                           bool raw) {
  // Of sums and unit apart, as their product may be beyond the doubles.
  const double exposure = raw              ? unit
                          : light.exposure ? *light.exposure * unit
                                           : automatic_exposure(counts);
  constexpr auto kMost = static_cast<double>(std::numeric_limits<float>::max());
  LightPicture picture;
  picture.rgb.reserve(counts.size());
  if (!raw && light.tone == ToneCurve::gamma) {
    const GammaCurve curve(light.gamma);
    for (const double count : counts) picture.rgb.push_back(curve(count * exposure));
    return picture;
  }
  for (const double count : counts) {
    const double shown = std::min(count * exposure, kMost);
    picture.rgb.push_back(raw ? static_cast<float>(shown) : toned(light.tone, shown));
  }
  return picture;
}

std::uint64_t light_bytes(const Scene& scene, unsigned threads) {
  const Film& film = scene.film;
  constexpr std::uint64_t kBytesOfPixel =
      3 * (sizeof(std::int64_t) + sizeof(double) + sizeof(float));
  constexpr std::uint64_t kBytesOfRay = 512;  // under way, where it arrives, its line
  const std::uint64_t pixels =
      static_cast<std::uint64_t>(film.width) * static_cast<std::uint64_t>(film.height);
  return LightFilm::bytes(film.width, film.height, 3, threads) + kBytesOfPixel * pixels +
         kBytesOfRay * (std::min(scene.light.rays, kLightBlock) + scene.lamps.size());
}

TracedLight trace_frame_light(const Scene& scene, const FrameState& state, const Tracer* tracer,
                              std::uint64_t seed, unsigned threads, bool (*stop)()) {
  const LitFrame lit(scene, state);
  if (lit.lamps.empty()) return {LightFilm(lit.place.width, lit.place.height, 3), 0, {}};
  return trace_light(lit.worlds, lit.scatterers, lit.lamps, lit.place,
                     {scene.light, seed, noise_frame(scene, state), threads, tracer, stop});
}

GatheredLight gather_frame_light(const Scene& scene, const FrameState& state, const Tracer* tracer,
                                 std::uint64_t seed, unsigned threads, bool (*stop)()) {
  const LitFrame lit(scene, state);
  return gather_light(lit.worlds.front(), lit.scatterers, lit.lamps, lit.place,
                      {scene.light, seed, noise_frame(scene, state), threads, tracer, stop});
}

bool is_gathered(const Scene& scene, const FrameState& state) {
  if (scene.light.estimator != LightEstimator::automatic)
    return scene.light.estimator == LightEstimator::backward;
  if (why_not_backward(scene)) return false;
  const Bounds all = bounds_of(build_world(scene, state).surfaces);
  const FilmTransform film(scene.film, state);
  const double pixel = 1 / film.scale();
  return all.size().prod() > kSmallPart * (scene.film.width * pixel) * (scene.film.height * pixel);
}

namespace {

// Light in numbers of a unit: their product may be beyond the doubles.
struct CountedLight {
  std::vector<double> counts;
  double unit;
};

CountedLight counted_light(const Scene& scene, const FrameState& state, const Tracer* tracer,
                           std::uint64_t seed, const LightRun& run) {
  if (is_gathered(scene, state))
    return {gather_frame_light(scene, state, tracer, seed, run.threads, run.stop).fluence, 1};
  const TracedLight light = trace_frame_light(scene, state, tracer, seed, run.threads, run.stop);
  const std::vector<std::int64_t> sums = light.film.sums();
  return {{sums.begin(), sums.end()}, light.unit};
}

}  // namespace

std::vector<double> frame_fluence(const Scene& scene, const FrameState& state, const Tracer* tracer,
                                  std::uint64_t seed, const LightRun& run) {
  const auto [counts, unit] = counted_light(scene, state, tracer, seed, run);
  std::vector<double> fluence(counts);
  for (double& one : fluence) one *= unit;
  return fluence;
}

LightPicture frame_light_picture(const Scene& scene, const FrameState& state, const Tracer* tracer,
                                 std::uint64_t seed, const LightRun& run) {
  const auto [counts, unit] = counted_light(scene, state, tracer, seed, run);
  return light_picture(counts, unit, scene.light, run.raw);
}

}  // namespace flatray
