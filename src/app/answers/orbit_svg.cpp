#include <algorithm>

#include "app/answers/orbit_report.h"
#include "study/plots/plot.h"
#include "study/rooms/wall_places.h"

namespace flatray {
namespace {

constexpr std::size_t kMostNumbers = 60;  // of all bounces that are shown

// All walls as one line with gaps.
Plot::Series walls_of(const OrbitRoom& room) {
  const Surfaces& walls = room.world.surfaces;
  Plot::Series lines{"", {}, false, "axis", 1};
  for (const auto* numbers : {&walls.segment_numbers, &walls.curve_numbers})
    for (const std::uint32_t surface : *numbers) {
      for (const Vec2& point : wall_outline(walls, surface))
        lines.points.push_back({point.x(), point.y()});
      lines.points.push_back(Plot::gap());
    }
  return lines;
}

void add(Plot& plot, const OrbitReport& report, std::size_t number, bool with_numbers) {
  const Orbit& orbit = report.orbit;
  Plot::Series path{report.ray, {{orbit.start.x(), orbit.start.y()}}};
  std::vector<OrbitLine> lines = orbit_lines(orbit);
  if (leaves(orbit))  // as far as the border, by what the axes cut off
    lines.back().line.b = lines.back().line.a + 2 * plot.window->size().lpNorm<1>() /
                                                    orbit.out.lpNorm<Eigen::Infinity>() * orbit.out;
  Vec2 last = orbit.start;
  for (const OrbitLine& part : lines) {
    const auto& [a, b] = part.line;
    if (a != last) path.points.insert(path.points.end(), {Plot::gap(), {a.x(), a.y()}});
    path.points.push_back({b.x(), b.y()});
    last = b;
  }
  Plot::Series start{"", {{orbit.start.x(), orbit.start.y()}}, true, series_ink(number), 2};
  Plot::Series certain{"", {}, true, series_ink(number), 1}, doubtful{"", {}, true, "axis", 1};
  const std::size_t count = orbit.bounces.size();
  for (std::size_t i = 0; i < std::min(count, kMostNumbers); ++i) {
    const Vec2& at = orbit.bounces[i].point;
    (i < report.certain ? certain : doubtful)
        .points.push_back({at.x(), at.y(), 0, with_numbers ? std::to_string(i + 1) : ""});
  }
  for (Plot::Series* series : {&path, &start, &certain, &doubtful})
    plot.series.push_back(std::move(*series));
}

}  // namespace

std::string svg_of(const OrbitRoom& room, const std::vector<OrbitReport>& reports) {
  Plot plot{"Orbits in " + room.scene.name, "x, world units", "y, world units", {walls_of(room)}};
  plot.window = room.window;
  plot.equal = true;
  std::size_t bounces = 0;
  for (const OrbitReport& report : reports) bounces += report.orbit.bounces.size();
  for (std::size_t i = 0; i < reports.size(); ++i)
    add(plot, reports[i], i, bounces <= kMostNumbers);
  return svg(plot);
}

}  // namespace flatray
