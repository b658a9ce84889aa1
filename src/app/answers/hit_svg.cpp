#include <algorithm>
#include <array>
#include <cmath>

#include "anim/world.h"
#include "app/answers/hit_report.h"
#include "geom/bounds.h"
#include "geom/clip.h"
#include "study/plots/plot.h"
#include "study/plots/plot_axes.h"
#include "study/rooms/wall_places.h"

namespace flatray {
namespace {

constexpr double kMargin = 0.08;

Vec2 at(const Ray& ray, double t) { return ray.origin + t * ray.direction; }
Plot::Point point(const Vec2& place) { return {place.x(), place.y()}; }

// The walls of an entity as one line with gaps; their box has been added to `box`.
void add_walls(const Scene& scene, const FrameState& state, std::uint32_t entity,
               Plot::Series& lines, Bounds& box) {
  World world;
  add_shape(world, shape_of(scene, state.entities[entity]), entity_pose(state, entity), {});
  for (std::uint32_t wall = 0; wall < world.surfaces.size(); ++wall) {
    for (const Vec2& corner : wall_outline(world.surfaces, wall)) {
      box.add(corner);
      lines.points.push_back(point(corner));
    }
    lines.points.push_back(Plot::gap());
  }
}

// What of a ray lies in the picture.
Range shown_part(const Bounds& box, const Ray& ray, Range within) {
  const std::array<Vec2, 4> corners = {
      box.low, {box.high.x(), box.low.y()}, box.high, {box.low.x(), box.high.y()}};
  const HitInterval part = clip_convex(ray, corners, within);
  return {std::max(part.t_enter, -1e300), std::min(part.t_exit, 1e300)};
}

}  // namespace

std::string svg_of(const Scene& scene, const FrameState& state,
                   std::span<const std::uint32_t> entities, std::span<const HitReport> reports) {
  Plot plot{"Rays against shapes of " + scene.name, "x, world units", "y, world units", {}};
  Plot::Series walls{"", {}, false, "axis"}, rays{"ray", {}, false, "blue"},
      origins{"", {}, true, "blue"}, inside{"inside", {}, false, "vermillion", 4},
      ends{"", {}, true, "vermillion"};
  Bounds box;
  for (const std::uint32_t entity : entities) add_walls(scene, state, entity, walls, box);
  for (const HitReport& report : reports) {
    box.add(report.ray.ray.origin);
    if (std::isfinite(report.within.high)) box.add(at(report.ray.ray, report.within.high));
  }
  const double size = box.size().maxCoeff(),
               far = box.low.cwiseAbs().cwiseMax(box.high.cwiseAbs()).maxCoeff();
  // Wide enough for doubles to tell its sides apart.
  const Vec2 margin = Vec2::Constant(std::max({kMargin * size, far * 0x1p-40, size > 0 ? 0 : 0.5}));
  plot.window = Bounds{box.low - margin, box.high + margin};
  plot.equal = true;
  for (const HitReport& report : reports) {
    const Ray& ray = report.ray.ray;
    const Range shown = shown_part(*plot.window, ray, report.within);
    const auto add = [&](Plot::Series& to, const Range& part) {
      if (part.low <= part.high)
        to.points.insert(to.points.end(),
                         {point(at(ray, part.low)), point(at(ray, part.high)), Plot::gap()});
    };
    const NamedRay* const before = &report == &reports.front() ? nullptr : &(&report - 1)->ray;
    if (before == nullptr || report.ray.name != before->name || ray.origin != before->ray.origin ||
        ray.direction != before->ray.direction) {
      add(rays, shown);
      origins.points.push_back({ray.origin.x(), ray.origin.y(), 0, report.ray.name});
    }
    if (!report.hit) continue;
    add(inside, {std::max(report.hit.t_enter, shown.low), std::min(report.hit.t_exit, shown.high)});
    const auto mark = [&](double t) {
      if (std::isfinite(t))
        ends.points.push_back({at(ray, t).x(), at(ray, t).y(), 0, "t = " + tick_words(t)});
    };
    mark(report.hit.t_enter);
    if (report.hit.t_exit != report.hit.t_enter) mark(report.hit.t_exit);
  }
  for (Plot::Series* series : {&walls, &rays, &origins, &inside, &ends})
    plot.series.push_back(std::move(*series));
  return svg(plot);
}

}  // namespace flatray
