#include <fmt/core.h>

#include <cmath>
#include <map>

#include "base/portable_math.h"
#include "study/estimate.h"
#include "study/palette.h"
#include "study/pixel_map.h"
#include "study/svg_plot.h"
#include "study/table.h"

namespace flatray {
namespace {

using Kind = PixelOutcome::Kind;

constexpr std::uint64_t kBounces = 1000;
constexpr std::uint32_t kSettled = 3;  // bounces after which escape is that of the trapped orbits
constexpr Light kSolid{0.02, 0.02, 0.025}, kTrapped{1, 1, 1};

// Who absorbed a ray: an entity, pillar or chamber, as one number.
using Exit = std::pair<SurfaceOwner::Kind, std::uint64_t>;

class Basins {
 public:
  Basins(const ExperimentContext& context, const Room& room, std::vector<PixelOutcome> pixels)
      : context_(context), room_(room), pixels_(std::move(pixels)) {
    for (const PixelOutcome& pixel : pixels_) {
      if (pixel.kind == Kind::solid) continue;
      ++free_;
      if (pixel.kind == Kind::limit) ++trapped_;
      if (pixel.kind == Kind::escape) ++escaped_;
      if (pixel.kind == Kind::absorbed) ++exits_[exit_of(pixel)];
      if (pixel.kind == Kind::limit) continue;
      if (pixel.bounces >= gone_after_.size()) gone_after_.resize(pixel.bounces + 1);
      ++gone_after_[pixel.bounces];
    }
    add_tail();
  }

  ExperimentResult result() const {
    ExperimentResult all = measured(context_, "escape", headline(), measures());
    Table table({"bounces", "escaped", "remaining"});
    Plot plot{"Orbits that remain", "bounces", "orbits", {{"remaining", {}, true}}, true};
    std::uint64_t remaining = free_;
    for (std::size_t n = 0; n < gone_after_.size(); ++n) {
      remaining -= gone_after_[n];
      table.add({std::uint64_t{n}, gone_after_[n], remaining});
      plot.series[0].points.push_back({static_cast<double>(n), static_cast<double>(remaining)});
    }
    all.files.push_back({"escape_times.csv", table.csv()});
    all.files.push_back({"escape_times.svg", svg(plot)});
    all.files.push_back(png_file("escape.png", picture(), context_.threads));
    return all;
  }

 private:
  Exit exit_of(const PixelOutcome& pixel) const {
    const SurfaceOwner& owner = room_.owner(pixel.surface);
    return {owner.kind, owner.kind == SurfaceOwner::Kind::pillar ? owner.pillar : owner.index};
  }

  std::string exit_name(const Exit& exit) const {
    const auto& [kind, index] = exit;
    const Scene& scene = context_.scene;
    return kind == SurfaceOwner::Kind::entity    ? scene.entities[index].name
           : kind == SurfaceOwner::Kind::chamber ? scene.chambers[index].name
                                                 : scene.chambers[0].pillars[index].name;
  }

  // Beyond some bounces the lengths of paths, and their numbers of bounces, fall off exponentially:
  // the rate is the inverse of the mean excess.
  void add_tail() {
    double least = 0, sum = 0, bounces = 0, count = 0;
    for (const PixelOutcome& pixel : pixels_)
      if (pixel.bounces == kSettled && gone(pixel)) least = std::max(least, pixel.length);
    for (const PixelOutcome& pixel : pixels_)
      if (gone(pixel) && pixel.length > least) {
        sum += pixel.length - least;
        ++count;
      }
    if (count > 1)
      tail_.push_back({"escape_rate_per_length", count / sum, count / sum / std::sqrt(count)});
    count = 0;
    for (const PixelOutcome& pixel : pixels_)
      if (gone(pixel) && pixel.bounces >= kSettled) {
        bounces += pixel.bounces - kSettled;
        ++count;
      }
    if (bounces > 0)
      tail_.push_back({"escape_rate_per_bounce", portable::log(1 + count / bounces),
                       1 / std::sqrt(bounces * (1 + bounces / count))});
  }
  static bool gone(const PixelOutcome& pixel) {
    return pixel.kind == Kind::escape || pixel.kind == Kind::absorbed;
  }

  std::vector<Measure> measures() const {
    const auto free = static_cast<double>(free_);
    const auto share = [&](std::string name, std::uint64_t count) {
      const double part = static_cast<double>(count) / free;
      return Measure{std::move(name), part, std::sqrt(part * (1 - part) / free)};
    };
    std::vector<Measure> all;
    for (const auto& [exit, count] : exits_) all.push_back(share("into " + exit_name(exit), count));
    all.push_back(share("into the open", escaped_));
    all.push_back(share("trapped", trapped_));
    all.insert(all.end(), tail_.begin(), tail_.end());
    return all;
  }

  std::string headline() const {
    return fmt::format(
        "{} x {} pixels, an orbit each: {} start in the free, {} stay for all bounces",
        context_.scene.film.width, context_.scene.film.height, free_, trapped_);
  }

  // Basins by colour: who absorbed the ray, or where it went; the darker the longer it stayed.
  Image picture() const {
    const Film& film = context_.scene.film;
    Image image(film.width, film.height, 3);
    std::map<Exit, std::size_t> colours;
    for (const auto& [exit, count] : exits_) colours.emplace(exit, colours.size());
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
      const PixelOutcome& pixel = pixels_[i];
      Light light = kSolid;
      if (pixel.kind == Kind::limit) light = kTrapped;
      if (gone(pixel)) {
        light =
            pixel.kind == Kind::escape ? hue_of(pixel.out) : nth_colour(colours[exit_of(pixel)]);
        light = light * (0.06 + 0.94 * portable::exp(-0.45 * pixel.bounces));
      }
      const auto width = static_cast<std::size_t>(film.width);
      set_pixel(image, static_cast<int>(i % width), static_cast<int>(i / width), light);
    }
    return image;
  }

  const ExperimentContext& context_;
  const Room& room_;
  std::vector<PixelOutcome> pixels_;
  std::uint64_t free_ = 0, trapped_ = 0, escaped_ = 0;
  std::map<Exit, std::uint64_t> exits_;
  std::vector<std::uint64_t> gone_after_;  // by number of bounces
  std::vector<Measure> tail_;
};

Result<ExperimentResult> run(const ExperimentContext& context) {
  const Room room(context.scene);
  if (auto walls = expect_walls(context, room); !walls) return fail(std::move(walls));
  auto pixels = trace_pixels(context, room, context.bounces.value_or(kBounces), PixelMap::angle);
  if (!pixels) return fail(std::move(pixels));
  return Basins(context, room, std::move(*pixels)).result();
}

}  // namespace

namespace experiment_entries {
extern const Experiment escape = {
    "escape",
    "Where does a ray from each pixel leave, and after how many bounces?",
    &run,
    {.bounces = true, .map = true, .resume = true}};
}  // namespace experiment_entries

}  // namespace flatray
