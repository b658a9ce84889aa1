#include <cmath>
#include <map>
#include <span>

#include "anim/rays.h"
#include "base/counted.h"
#include "render/pass.h"
#include "render/ray_walls.h"
#include "scene/curve.h"
#include "scene/outlines/easy_font.h"
#include "transport/moving_orbit.h"

namespace flatray::orbits_pass {
namespace {

// Marks are this many times as wide as the line they stand on.
constexpr double kMarkWidths = 2.5;

Need need(const Scene& scene) {
  if (scene.rays.empty()) return skip("no rays");
  return run(counted(scene.rays.size(), "ray"));
}

// As far along the ray as anything the window shows, and farther.
Vec2 beyond_window(const Bounds& window, const Vec2& from, const Vec2& out) {
  const double reach = window.size().lpNorm<1>() + (from - window.centre()).lpNorm<1>();
  return from + reach * out;
}

// Lines of a path from `length` world units on are not flown yet.
void cut_to(std::vector<OrbitLine>& path, double length) {
  for (std::size_t i = 0; i < path.size(); ++i) {
    Segment& line = path[i].line;
    const Vec2 way = line.b - line.a;
    const double size = std::sqrt(way.dot(way));
    if (size > length) {
      line.b = line.a + length / size * way;
      path[i].reflected = false;
      path.resize(i + 1);
      return;
    }
    length -= size;
  }
}

// Orbits are followed to where the flight after the last bounce arrives: that is no bounce of the ray.
constexpr std::uint64_t kLastFlight = 1;
bool arrives(const RayPath& ray, const Orbit& orbit) { return orbit.bounces.size() > ray.bounces; }

std::vector<OrbitLine> shown_path(const DrawContext& context, const RayPath& ray,
                                  const Orbit& orbit) {
  std::vector<OrbitLine> path = orbit_lines(orbit);
  if (arrives(ray, orbit)) path.back().reflected = false;
  if (leaves(orbit))
    path.back().line.b = beyond_window(context.state.window, path.back().line.a, orbit.out);
  if (ray.ball) cut_to(path, ray.ball->speed * context.state.time);
  return path;
}

// From mirror to mirror as they moved, up to the time of the frame.
std::vector<OrbitLine> way_so_far(const RayPath& ray, const Orbit& orbit) {
  std::vector<OrbitLine> path;
  Vec2 last = orbit.start;
  for (const Bounce& bounce : orbit.bounces) {
    path.push_back({{last, bounce.point}, true});
    last = bounce.point;
  }
  if (arrives(ray, orbit)) path.back().reflected = false;
  if (orbit.end_point != last) path.push_back({{last, orbit.end_point}, false});
  return path;
}

void displace(Orbit& orbit, const Vec2& by) {
  orbit.start += by;
  for (Bounce& bounce : orbit.bounces) bounce.point += by;
  orbit.end_point += by;
}

std::uint8_t between(std::uint8_t a, std::uint8_t b, double part) {
  return static_cast<std::uint8_t>(a + part * (b - a) + 0.5);
}

// Lines of one colour after another, at most kShades of them.
void add_shaded(DrawContext& context, const Stroke& line, const Colour& to,
                std::span<const Segment> lines) {
  constexpr std::size_t kShades = 64;
  const std::size_t shades = std::min(kShades, lines.size());
  const Colour& from = line.colour;
  for (std::size_t i = 0; i < shades; ++i) {
    const std::size_t begin = i * lines.size() / shades, end = (i + 1) * lines.size() / shades;
    const double part = shades == 1 ? 0 : static_cast<double>(i) / static_cast<double>(shades - 1);
    Stroke stroke = line;
    stroke.colour = Colour{between(from.r, to.r, part), between(from.g, to.g, part),
                           between(from.b, to.b, part), between(from.a, to.a, part)};
    context.add_lines(lines.subspan(begin, end - begin), stroke);
  }
}

// A number beside a point, in letters of the film's pixels.
void add_number(DrawContext& context, const Vec2& point, std::size_t number, const Colour& colour) {
  constexpr double kBeside = 3;
  Shape shape;
  add_line(shape, font_line(std::to_string(number)), {kBeside, kBeside},
           1 / context.film_from_world.length(1));
  context.add_shape(shape, {point}, Paint(colour), std::nullopt);
}

void draw(DrawContext& context, const RayState& now, const Orbit& orbit,
          const std::vector<OrbitLine>& path) {
  constexpr std::size_t kMostNumbers = 999;
  const RayPath& ray = context.scene.rays[now.ray];
  std::vector<Segment> lines;
  for (const OrbitLine& part : path) lines.push_back(part.line);
  if (ray.end_colour)
    add_shaded(context, now.stroke, *ray.end_colour, lines);
  else
    context.add_lines(lines, now.stroke);
  const double radius_px = kMarkWidths * context.half_width_px(now.stroke);
  std::size_t bounces = 0;
  for (const OrbitLine& part : path) {
    if (!part.reflected) continue;
    ++bounces;
    if (ray.hit_points) context.add_mark(part.line.b, radius_px, *ray.hit_points);
    if (ray.numbers && bounces <= kMostNumbers)
      add_number(context, part.line.b, bounces, *ray.numbers);
  }
  const bool whole = path.empty() || path.back().line.b == orbit.end_point;
  const bool at_wall =
      orbit.end == OrbitEnd::absorbed || orbit.end == OrbitEnd::corner || arrives(ray, orbit);
  if (ray.hit_points && whole && at_wall)
    context.add_mark(orbit.end_point, radius_px, *ray.hit_points);
  if (ray.ball)
    context.add_mark(path.empty() ? orbit.start : path.back().line.b,
                     context.film_from_world.length(
                         now.scale * plus(context.scene, ray.ball->radius, context.state.time)),
                     ray.ball->colour);
}

// Rays of as many bounces are advanced together, a few at a time: orbits are long.
constexpr std::size_t kRaysAtOnce = 64;

void draw_some(DrawContext& context, const OrbitTracer& tracer,
               std::span<const RayState* const> rays, std::uint64_t bounces) {
  std::vector<OrbitStart> starts;
  for (const RayState* now : rays)
    starts.push_back({now->start, {}, chance_of_orbit(context.timeline.seed(), now->ray)});
  const std::vector<Orbit> orbits =
      trace_orbits(tracer, std::span<const OrbitStart>(starts), bounces + kLastFlight);
  for (std::size_t k = 0; k < rays.size(); ++k) {
    const RayPath& ray = context.scene.rays[rays[k]->ray];
    context.place(ray.layer, ray.order, ray.where);
    context.fade(rays[k]->opacity,
                 [&] { draw(context, *rays[k], orbits[k], shown_path(context, ray, orbits[k])); });
  }
}

// Each has a way of its own in time: it set off in frame 1, and looks as it does now.
void draw_moving(DrawContext& context, std::span<const RayState> rays) {
  if (std::none_of(context.scene.rays.begin(), context.scene.rays.end(),
                   [](const RayPath& ray) { return ray.speed.has_value(); }))
    return;
  const MovingWalls walls = moving_walls(context.timeline);
  std::map<std::uint32_t, Ray> starts;
  for (const RayState& first : ray_states(context.scene, 0)) starts[first.ray] = first.start;
  for (const RayState& now : rays) {
    const RayPath& ray = context.scene.rays[now.ray];
    const auto start = starts.find(now.ray);
    if (!ray.speed || start == starts.end()) continue;
    if (context.refused()) return;
    const auto& [at, direction] = start->second;
    Orbit orbit = trace_moving_orbit(walls, {at, at_speed(direction, *ray.speed)}, 0,
                                     {ray.bounces + kLastFlight, context.state.time})
                      .orbit;
    displace(orbit, context.state.displaced);
    context.place(ray.layer, ray.order, ray.where);
    context.fade(now.opacity, [&] { draw(context, now, orbit, way_so_far(ray, orbit)); });
  }
}

void draw_all(DrawContext& context) {
  const std::vector<RayState> rays = ray_states(context.scene, context.state);
  draw_moving(context, rays);
  if (!need_of_ray_walls(context.scene).needed) return;
  const RayWalls walls(context.scene, context.state, context.tracer);
  std::map<std::uint64_t, std::vector<const RayState*>> by_bounces;
  for (const RayState& now : rays)
    if (const RayPath& ray = context.scene.rays[now.ray]; !ray.speed)
      by_bounces[ray.bounces].push_back(&now);
  for (const auto& [bounces, alike] : by_bounces)
    for (std::size_t begin = 0; begin < alike.size(); begin += kRaysAtOnce) {
      if (context.refused()) return;
      const std::size_t count = std::min(kRaysAtOnce, alike.size() - begin);
      draw_some(context, walls.orbits(), std::span(alike).subspan(begin, count), bounces);
    }
}

}  // namespace

extern const Pass entry = {"orbits", &need, &draw_all};

}  // namespace flatray::orbits_pass
