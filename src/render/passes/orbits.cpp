#include "render/pass.h"
#include "transport/orbit.h"

namespace flatray {
namespace {

// Marks are this many times as wide as the line they stand on.
constexpr double kMarkWidths = 2.5;

Need need(const Scene& scene) {
  if (scene.rays.empty()) return skip("no rays");
  return run(std::to_string(scene.rays.size()) + " rays");
}

// Farther along the ray than anything the window shows.
Vec2 beyond_window(const Bounds& window, const Vec2& from, const Vec2& out) {
  const double reach = window.size().lpNorm<1>() + (from - window.centre()).lpNorm<1>();
  return from + reach * out;
}

std::vector<Segment> path(const Orbit& orbit, const Bounds& window) {
  std::vector<Segment> lines;
  Vec2 last = orbit.start;
  for (const Bounce& bounce : orbit.bounces) {
    lines.push_back({last, bounce.point});
    last = bounce.point;
  }
  if (orbit.end == OrbitEnd::escape)
    lines.push_back({last, beyond_window(window, last, orbit.out)});
  if (orbit.end == OrbitEnd::absorbed || orbit.end == OrbitEnd::corner)
    lines.push_back({last, orbit.end_point});
  return lines;
}

void draw(DrawContext& context, const RayPath& ray, const Orbit& orbit) {
  context.add_lines(path(orbit, context.state.window), ray.stroke);
  if (!ray.hit_points) return;
  const double radius_px = kMarkWidths * context.half_width_px(ray.stroke);
  for (const Bounce& bounce : orbit.bounces)
    context.add_mark(bounce.point, radius_px, *ray.hit_points);
  if (orbit.end == OrbitEnd::absorbed || orbit.end == OrbitEnd::corner)
    context.add_mark(orbit.end_point, radius_px, *ray.hit_points);
}

void draw_all(DrawContext& context) {
  const World& world = context.world();
  const std::vector<Material> materials = world.materials();
  for (const RayPath& ray : context.scene.rays) {
    if (context.refused()) return;
    const Orbit orbit = trace_orbit(
        world.surfaces, materials, {world_pose(context.state)(ray.at), ray.direction}, ray.bounces);
    context.place(ray.layer, ray.order, ray.where);
    context.fade(ray.opacity, [&] { draw(context, ray, orbit); });
  }
}

}  // namespace

extern const Pass orbits_pass;
const Pass orbits_pass = {"orbits", &need, &draw_all};

}  // namespace flatray
