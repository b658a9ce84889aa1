#include <map>
#include <span>

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

// Rays of as many bounces are advanced together, a few at a time: orbits are long.
constexpr std::size_t kRaysAtOnce = 64;

void draw_some(DrawContext& context, std::span<const Material> materials,
               std::span<const std::size_t> numbers, std::uint64_t bounces) {
  std::vector<Ray> starts;
  for (const std::size_t i : numbers) {
    const RayPath& ray = context.scene.rays[i];
    starts.push_back({world_pose(context.state)(ray.at), ray.direction});
  }
  const std::vector<Orbit> orbits =
      trace_orbits(context.world().surfaces, materials, starts, bounces);
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const RayPath& ray = context.scene.rays[numbers[k]];
    context.place(ray.layer, ray.order, ray.where);
    context.fade(ray.opacity, [&] { draw(context, ray, orbits[k]); });
  }
}

void draw_all(DrawContext& context) {
  const std::vector<RayPath>& rays = context.scene.rays;
  const std::vector<Material> materials = context.world().materials();
  std::map<std::uint64_t, std::vector<std::size_t>> by_bounces;
  for (std::size_t i = 0; i < rays.size(); ++i) by_bounces[rays[i].bounces].push_back(i);
  for (const auto& [bounces, numbers] : by_bounces)
    for (std::size_t begin = 0; begin < numbers.size(); begin += kRaysAtOnce) {
      if (context.refused()) return;
      const std::size_t count = std::min(kRaysAtOnce, numbers.size() - begin);
      draw_some(context, materials, std::span(numbers).subspan(begin, count), bounces);
    }
}

}  // namespace

extern const Pass orbits_pass;
const Pass orbits_pass = {"orbits", &need, &draw_all};

}  // namespace flatray
