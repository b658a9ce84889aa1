#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "geom/predicates.h"
#include "study/blocks.h"
#include "study/estimate.h"
#include "study/line_density.h"
#include "study/palette.h"
#include "study/scene_orbits.h"

namespace flatray {
namespace {

constexpr std::uint64_t kBounces = 10'000;

// The light of one path, and how near its lines come to a point.
class Lines : public OrbitSink {
 public:
  Lines(const Room& room, const OrbitStart& start, const Vec2& middle)
      : density_(room.state().window, room.scene().film.width, room.scene().film.height),
        middle_(middle),
        last_(start.ray.origin) {
    see(start.ray.direction);
  }
  void bounce(std::size_t, const Bounce& bounce) override {
    density_.add(last_, bounce.point);
    last_ = bounce.point;
    see(bounce.out);
  }
  void cross(std::size_t, const Vec2& from, const Vec2& to) override {
    density_.add(last_, from);
    last_ = to;
  }
  void end(std::size_t, const OrbitStop& stop) override {
    if (stop.end == OrbitEnd::absorbed || stop.end == OrbitEnd::corner)
      density_.add(last_, stop.point);
  }
  Numbers numbers() const {
    Numbers all{first_, nearest_, farthest_};
    all.insert(all.end(), density_.cells().begin(), density_.cells().end());
    return all;
  }

 private:
  void see(const Vec2& direction) {
    const double size = std::sqrt(direction.x() * direction.x() + direction.y() * direction.y());
    const double distance = std::fabs(flatray::cross(Vec2(last_ - middle_), direction)) / size;
    if (nearest_ > farthest_) first_ = distance;
    nearest_ = std::min(nearest_, distance);
    farthest_ = std::max(farthest_, distance);
  }
  LineDensity density_;
  Vec2 middle_, last_;
  double first_ = 0, nearest_ = kInfinity, farthest_ = 0;
};

Result<ExperimentResult> run(const ExperimentContext& context) {
  const Room room(context.scene);
  if (auto walls = expect_walls(context, room); !walls) return fail(std::move(walls));
  const NamedOrbits orbits = orbits_to_watch(context, room, 1);
  const bool round = room.walls().size() == 1 && room.walls().circles.size() == 1;
  const Vec2 middle =
      round ? room.walls().circles.front().centre : Vec2(room.state().window.centre());
  const std::uint64_t bounces = context.bounces.value_or(kBounces);
  auto found = run_blocks(context, orbits.starts.size(), [&](std::size_t i) {
    Lines lines(room, orbits.starts[i], middle);
    room.orbits().follow(std::span(&orbits.starts[i], 1), bounces, lines);
    return lines.numbers();
  });
  if (!found) return fail(std::move(found));
  std::vector<Measure> measures;
  const Film& film = context.scene.film;
  LineDensity all(room.state().window, film.width, film.height);
  for (std::size_t i = 0; i < found->size(); ++i) {
    const Numbers& one = (*found)[i];
    // In a circle every line of a path is as far from the centre as the first.
    const auto truth = round ? std::optional(one[0]) : std::nullopt;
    const double rounding = static_cast<double>(bounces) * 0x1p-50;
    measures.push_back({orbits.names[i] + ": nearest line to the middle", one[1], rounding, truth});
    measures.push_back({orbits.names[i] + ": farthest line", one[2], rounding, truth});
    all.add_cells(std::span(one).subspan(3));
  }
  ExperimentResult result =
      measured(context, "caustic",
               fmt::format("Distances of the lines of {} bounces from ({:.6g}, {:.6g})", bounces,
                           middle.x(), middle.y()),
               std::move(measures));
  result.files.push_back(png_file("caustic.png", all.picture(), context.threads));
  return result;
}

}  // namespace

namespace experiment_entries {
extern const Experiment caustic = {
    "caustic",
    "What do the lines of a path leave free, and how sharp is its edge?",
    &run,
    {.bounces = true, .seed = true, .resume = true}};
}  // namespace experiment_entries

}  // namespace flatray
