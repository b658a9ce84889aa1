#include "study/periodic/periodic_plots.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "study/rooms/wall_places.h"

namespace flatray {
namespace {

constexpr std::size_t kMostShown = 7;  // as many as there are colours

Plot::Series line_through(std::string name, const std::vector<Vec2>& points, bool closed) {
  Plot::Series series{std::move(name)};
  for (const Vec2& point : points) series.points.push_back({point.x(), point.y()});
  if (closed) series.points.push_back(series.points.front());
  return series;
}

// The number of a mirror: in a disc, else beside the middle of it, where no orbits are or, of a
// wall with orbits on both sides, on one.
Plot::Point number_of(const MirrorRoom& room, std::size_t i, const std::vector<Plot::Point>& wall) {
  constexpr double kAway = 0.075;
  const Plot::Point &a = wall[(wall.size() - 1) / 2], &b = wall[wall.size() / 2];
  const Mirror& mirror = room.mirrors[i];
  const Surfaces& walls = room.room.walls();
  Vec2 at(a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2);
  if (mirror.is_disc() && mirror.arc->extent == Arc::Extent::whole)
    at = mirror.arc->curve.centre;
  else
    at -= static_cast<double>(mirror.side.value_or(Sign::positive)) * kAway *
          bounds_of(walls).size().maxCoeff() * wall_normal(walls, mirror.surface, at);
  Plot::Point number{at.x(), at.y()};
  number.label = std::to_string(i + 1);
  return number;
}

}  // namespace

Plot plot_of_orbits(const MirrorRoom& room, const std::vector<const ClosedOrbit*>& orbits) {
  Plot plot{"The shortest periodic orbits, by their walls in order", "x, world units",
            "y, world units"};
  plot.equal = true;
  Plot::Series numbers{"", {}, true, "axis", 0};
  for (std::size_t i = 0; i < room.mirrors.size(); ++i) {
    Plot::Series wall =
        line_through("", wall_outline(room.room.walls(), room.mirrors[i].surface), false);
    numbers.points.push_back(number_of(room, i, wall.points));
    wall.ink = "axis";
    wall.width = 2.5;
    plot.series.push_back(std::move(wall));
  }
  plot.series.push_back(std::move(numbers));
  std::vector<const ClosedOrbit*> sorted = orbits;
  std::ranges::stable_sort(sorted, [](const ClosedOrbit* a, const ClosedOrbit* b) {
    return a->length.value() < b->length.value() * (1 - 1e-9);
  });
  sorted.resize(std::min(kMostShown, sorted.size()));
  for (const ClosedOrbit* orbit : sorted) {
    const bool is_one_of_several =
        std::ranges::count(orbits, orbit->word, [](const auto* one) { return one->word; }) > 1;
    plot.series.push_back(line_through(
        room.text(orbit->word) +
            (is_one_of_several ? " (" + std::to_string(orbit->number) + ")" : std::string()),
        orbit->points, true));
  }
  return plot;
}

Plot plot_of_stability(const std::vector<const ClosedOrbit*>& orbits) {
  Plot plot{"Instability of the periodic orbits",
            "length, world units",
            "size of the larger eigenvalue",
            {},
            true};
  std::map<std::size_t, Plot::Series> by_bounces;
  for (const ClosedOrbit* orbit : orbits) {
    const auto value = orbit->eigenvalue();
    if (!value) continue;
    const std::size_t bounces = orbit->word.size();
    Plot::Series& series = by_bounces[bounces];
    series.name = std::to_string(bounces) + " bounces";
    series.marks = true;
    series.points.push_back({orbit->length.value(), std::fabs(value->value())});
  }
  for (auto& [bounces, series] : by_bounces) plot.series.push_back(std::move(series));
  return plot;
}

}  // namespace flatray
