#include "study/stability/margins.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "anim/rays.h"
#include "anim/world.h"
#include "geom/decide.h"
#include "geom/predicates.h"
#include "scene/names.h"
#include "study/rooms/starts.h"
#include "transport/orbit.h"

namespace flatray {
namespace {

struct Leg {
  Vec2 from, to;
  std::vector<std::uint32_t> ends_on{};  ///< walls, which may go on beyond `to`
  bool goes_on = false;                  ///< beyond `to`, as it does to the walls it ends on
};

// How far from a leg a point lies that is beside it; infinite where it is behind either end.
double beside(const Leg& leg, const Vec2& point) {
  const Vec2 way = leg.to - leg.from;
  const double length = way.norm(), along = way.dot(point - leg.from);
  const bool beyond = along > length * length && point != leg.to && !leg.goes_on;
  if (length == 0 || along <= 0 || beyond) return kInfinity;
  if (side_of_ray({leg.from, way}, point) == Sign::zero) return 0;
  return std::fabs(cross(way, Vec2(point - leg.from))) / length;
}

class MarginMeasure {
 public:
  MarginMeasure(const Scene& scene, const World& world) : scene_(scene), world_(world) {
    for (const Segment& wall : world.surfaces.segments) grow(wall.a), grow(wall.b);
    for (const Arc& wall : world.surfaces.arcs) {
      const Ellipse& curve = wall.curve;
      grow(curve.centre + curve.u), grow(curve.centre - curve.u);
      grow(curve.centre + curve.v), grow(curve.centre - curve.v);
    }
    for (const Bezier& wall : world.surfaces.beziers)
      for (int k = 0; k <= wall.degree; ++k) grow(wall.point(k));
  }

  Margin nearest(std::string ray, std::uint64_t number, const Leg& leg) const {
    Margin best{std::move(ray), number, "", {0, 0}, kInfinity, kInfinity};
    const Surfaces& walls = world_.surfaces;
    Leg seen = leg;
    for (std::uint32_t i = 0; i < walls.size(); ++i) {
      const auto see = [&](const Vec2& at, double distance) {
        if (distance >= best.distance) return;
        best.distance = distance;
        best.wall = name_of(i);
        best.at = at;
      };
      seen.goes_on = leg.goes_on || std::ranges::find(leg.ends_on, i) != leg.ends_on.end();
      walls.visit(i, [&](const auto& wall) { see_wall(wall, seen, see); });
    }
    best.ulps = best.distance / (largest_ * 0x1p-52);
    return best;
  }

  double largest() const { return largest_; }

 private:
  template <class See>
  static void see_wall(const Segment& wall, const Leg& leg, const See& see) {
    see(wall.a, beside(leg, wall.a));
    see(wall.b, beside(leg, wall.b));
  }
  template <class See>
  static void see_wall(const Arc& arc, const Leg& leg, const See& see) {
    if (arc.extent == Arc::Extent::between) {
      see(arc.from, beside(leg, arc.from));
      see(arc.to, beside(leg, arc.to));
    }
    const auto& [centre, u, v] = arc.curve;
    const Vec2 way = leg.to - leg.from;
    // A tangent along the leg touches it where a u + b v has (a, b) along this.
    const Vec2 across = Vec2(cross(way, u), cross(way, v)) / way.norm();
    const double half_width = across.norm();
    if (half_width == 0) return see(centre, beside(leg, centre));
    const double to_centre = cross(way, Vec2(centre - leg.from)) / way.norm();
    const Vec2 touched =
        centre - (across.x() * u + across.y() * v) * ((to_centre > 0 ? 1 : -1) / half_width);
    // Half a curve ends in the walls that it joins, which are seen; so may its tangent be.
    if (arc.extent == Arc::Extent::between && place_in_cone(arc, touched) == PlaceOn::outside)
      return;
    if (beside(leg, touched) == kInfinity) return;
    const Sign chord = decide([&](const auto& number) {
      return curve_time(number, Ray{leg.from, way}, arc.curve).q;
    });
    see(centre, chord == Sign::zero ? 0 : std::fabs(std::fabs(to_centre) - half_width));
  }
  template <class See>
  static void see_wall(const Bezier& wall, const Leg& leg, const See& see) {
    see(wall.start(), beside(leg, wall.start()));
    see(wall.end(), beside(leg, wall.end()));
  }
  void grow(const Vec2& p) { largest_ = std::max({largest_, std::fabs(p.x()), std::fabs(p.y())}); }

  std::string name_of(std::uint32_t wall) const {
    const SurfaceOwner& owner = world_.owner(wall);
    const bool entity = owner.kind == SurfaceOwner::Kind::entity;
    std::string text =
        entity ? entity_name(scene_, owner.index) : chamber_name(scene_, owner.index);
    if (owner.kind == SurfaceOwner::Kind::pillar)
      text += fmt::format(" pillar {}", owner.pillar + 1);
    return owner.edge < 0 ? text : fmt::format("{} edge {}", text, owner.edge);
  }

  const Scene& scene_;
  const World& world_;
  double largest_ = 0x1p-1000;
};

// The ways of the scene's own rays among its mirrors.
std::vector<Margin> of_rays(const Scene& scene, const FrameState& state) {
  const World world = build_world(scene, state);
  const MarginMeasure measure(scene, world);
  std::vector<Margin> all;
  for (const RayState& now : ray_states(scene, state)) {
    const RayPath& ray = scene.rays[now.ray];
    const std::string name = ray_name(scene, now.ray);
    const Orbit orbit = trace_orbit(world.surfaces, world.materials(), now.start, ray.bounces + 1);
    std::uint64_t leg = 0;
    const std::vector<OrbitLine> lines = orbit_lines(orbit);
    for (const OrbitLine& line : lines) {
      Leg way{line.line.a, line.line.b};
      if (line.reflected)
        way.ends_on = {orbit.bounces[leg].surface};
      else if (&line == &lines.back())
        way.ends_on = orbit.end_surfaces;
      if (leaves(orbit) && &line == &lines.back())  // as long as all that it could come by
        way.to = way.from + 8 * measure.largest() * (way.to - way.from);
      all.push_back(measure.nearest(name, leg, way));
      if (line.reflected) ++leg;
    }
  }
  return all;
}

// From anywhere in the window in any direction, to the wall met or out of the window.
std::vector<Margin> of_random(const Scene& scene, const FrameState& state, std::uint64_t seed,
                              std::uint64_t count) {
  const World world = build_world(scene, state, WorldOf::everything);
  const MarginMeasure measure(scene, world);
  const std::unique_ptr<Accelerator> walls = accelerate(world.surfaces);
  std::vector<Margin> all;
  for (std::uint64_t number = 0; number < count; ++number) {
    const auto [from, way] = random_ray(state.window, seed, number);
    const NearestHit hit = walls->nearest_of_one({from, way});
    const double t = hit ? hit.t : 2 * state.window.size().norm() / way.norm();
    all.push_back(measure.nearest(fmt::format("random {}", number + 1), 0,
                                  {from, from + t * way, {hit.surface}}));
  }
  return all;
}

}  // namespace

std::vector<Margin> margins(const Scene& scene, std::uint64_t seed, std::uint64_t count) {
  const FrameState state = at(Timeline(scene, seed, 1), 1);
  std::vector<Margin> all =
      scene.rays.empty() ? of_random(scene, state, seed, count) : of_rays(scene, state);
  std::erase_if(all, [](const Margin& margin) { return margin.wall.empty(); });
  std::ranges::stable_sort(all, {}, &Margin::distance);
  return all;
}

}  // namespace flatray
