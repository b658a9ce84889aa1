#include <map>

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

// The orbits of all rays, by ray: those of as many bounces are advanced together.
std::vector<Orbit> all_orbits(DrawContext& context) {
  const World& world = context.world();
  const std::vector<Material> materials = world.materials();
  const std::vector<RayPath>& rays = context.scene.rays;
  std::map<std::uint64_t, std::vector<std::size_t>> by_bounces;
  for (std::size_t i = 0; i < rays.size(); ++i) by_bounces[rays[i].bounces].push_back(i);
  std::vector<Orbit> orbits(rays.size());
  for (const auto& [bounces, numbers] : by_bounces) {
    std::vector<Ray> starts;
    for (const std::size_t i : numbers)
      starts.push_back({world_pose(context.state)(rays[i].at), rays[i].direction});
    std::vector<Orbit> traced = trace_orbits(world.surfaces, materials, starts, bounces);
    for (std::size_t i = 0; i < numbers.size(); ++i) orbits[numbers[i]] = std::move(traced[i]);
  }
  return orbits;
}

void draw_all(DrawContext& context) {
  const std::vector<Orbit> orbits = all_orbits(context);
  for (std::size_t i = 0; i < orbits.size(); ++i) {
    const RayPath& ray = context.scene.rays[i];
    if (context.refused()) return;
    context.place(ray.layer, ray.order, ray.where);
    context.fade(ray.opacity, [&] { draw(context, ray, orbits[i]); });
  }
}

}  // namespace

extern const Pass orbits_pass;
const Pass orbits_pass = {"orbits", &need, &draw_all};

}  // namespace flatray
