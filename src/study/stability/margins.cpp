#include "study/stability/margins.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "anim/rays.h"
#include "anim/world.h"
#include "geom/predicates.h"
#include "scene/names.h"
#include "study/rooms/starts.h"
#include "transport/orbit.h"

namespace flatray {
namespace {

struct Leg {
  Vec2 from, to;
};

// How far from a leg a point lies that is beside it; infinite where it is behind either end.
double beside(const Leg& leg, const Vec2& point) {
  const Vec2 way = leg.to - leg.from;
  const double length = way.norm(), along = way.dot(point - leg.from);
  if (length == 0 || along <= 0 || (along > length * length && point != leg.to)) return kInfinity;
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
    for (std::uint32_t i = 0; i < walls.size(); ++i) {
      const auto see = [&](const Vec2& at, double distance) {
        if (distance >= best.distance) return;
        best.distance = distance;
        best.wall = name_of(i);
        best.at = at;
      };
      walls.visit(i, [&](const auto& wall) { see_wall(wall, leg, see); });
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
    const auto circle = circle_along(arc);
    if (!circle) return;
    const auto& [centre, radius] = *circle;  // the way may end on it, short of its foot
    const Vec2 way = leg.to - leg.from;
    const Leg longer{leg.from, leg.to + (radius / way.norm()) * way};
    see(centre, std::fabs(beside(longer, centre) - radius));
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
    all.push_back(measure.nearest(fmt::format("random {}", number + 1), 0, {from, from + t * way}));
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
