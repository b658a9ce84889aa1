#include "study/rooms/room.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "anim/rays.h"
#include "base/counted.h"
#include "base/portable_math.h"
#include "collide/broad_phase.h"
#include "collide/pillars.h"
#include "scene/names.h"
#include "scene/part_counts.h"
#include "study/rooms/starts.h"
#include "study/rooms/wall_places.h"
#include "transport/exact_origin.h"
#include "transport/near_doubles.h"
#include "transport/reflection.h"

namespace flatray {

DepartedSurface departed_by(const Surfaces& walls, const Bounce& bounce) {
  return walls.visit(bounce.surface, [&](const auto& wall) -> DepartedSurface {
    const bool out = bounce.normal.dot(normal_near(wall, bounce.point)) > 0;
    return {bounce.surface, root_departed(wall, out ? Sign::positive : Sign::negative)};
  });
}

std::optional<Vec2> in_front_of(const Surfaces& walls, std::uint32_t surface, Sign side,
                                const Vec2& place) {
  return nearest_double(place, [&](const Vec2& point) {
    return walls.visit(surface, [&](const auto& wall) { return side_of(wall, point) != -side; });
  });
}

Room::Room(const Scene& scene) : scene_(scene), state_(at(Timeline(scene, scene.seed, 1), 1)) {
  for (std::uint32_t i = 0; i < walls().size(); ++i) {
    counted_.push_back(counted_wall(i));
    has_copies_ |= counted_.back() != i;
    weights_.push_back(weights_of(i));
    before_.push_back(before_.back() + (weights_[i][0] + weights_[i][1]) * places_.length(i));
  }
  orbits_ = std::make_unique<OrbitTracer>(walls(), materials_,
                                          OrbitRules{.field = scene.field(), .glass = &glass_});
  const bool closed = !scene.chambers.empty() &&
                      part_counts(scene.shapes[scene.chambers.front().shape]).areas() > 0;
  fast_ = std::make_unique<FastOrbits>(*orbits_, closed);
}

// A chamber is bounced in from inside, whatever stands in it or in the open from outside. Edges
// run counter-clockwise; both sides of a lone segment or arc are outside.
std::optional<Sign> Room::inner_side(std::uint32_t surface) const {
  if (materials_[surface] == Material::glass) return std::nullopt;
  const SurfaceOwner& owner = world_.owner(surface);
  const bool chamber = owner.kind == SurfaceOwner::Kind::chamber;
  const Sign inside = walls().visit(surface, [](const auto& wall) { return inside_of(wall); });
  const ShapeId shape = chamber ? scene_.chambers[owner.index].shape
                        : owner.kind == SurfaceOwner::Kind::pillar
                            ? scene_.chambers[owner.index].pillars[owner.pillar].shape
                            : state_.entities[owner.index].shape;
  const Shape& whole = scene_.shapes[shape];
  if (part_counts(whole).areas() == 0) return std::nullopt;
  return chamber ? inside : -inside;
}

bool Room::has_start(const Vec2& point) const {
  return !ExactOrigins(walls()).walls_at(point).empty() || is_free(point);
}

bool Room::is_free(const Vec2& point) const {
  const auto holder = solids_.holder(point);
  return (!holder || holder->material == Material::glass) && solids_.in_chamber(point);
}

// Bounces are spread evenly over lengths and tangential momenta, which are the index times the
// sine.
std::array<double, 2> Room::weights_of(std::uint32_t surface) const {
  if (materials_[surface] == Material::periodic || counted_[surface] != surface) return {0, 0};
  if (materials_[surface] == Material::glass) return glass_.indices(surface);
  const auto side = inner_side(surface);
  return {side == Sign::negative ? 0.0 : 1.0, side == Sign::positive ? 0.0 : 1.0};
}

double Room::area() const {
  double sum = solids_.free_area();
  for (std::uint32_t i = 0; i < walls().size(); ++i) {
    const SurfaceOwner& body = owner(i);
    const bool first =
        i == 0 || owner(i - 1).kind != body.kind || owner(i - 1).pillar != body.pillar;
    if (materials_[i] != Material::glass || !first) continue;
    const auto [positive, negative] = glass_.indices(i);
    sum += positive * negative * solids_.pillar_area(body.index, body.pillar);  // one of them is 1
  }
  return sum;
}

double Room::index_ratio(const Bounce& bounce) const {
  const auto [positive, negative] = glass_.indices(bounce.surface);
  const Vec2 normal = wall_normal(walls(), bounce.surface, bounce.point);
  return bounce.normal.dot(normal) > 0 ? positive / negative : negative / positive;
}

// Copies of discs, a wall each, come after what they are copies of.
std::uint32_t Room::counted_wall(std::uint32_t surface) const {
  const SurfaceOwner& owner = world_.owner(surface);
  if (owner.kind != SurfaceOwner::Kind::pillar) return surface;
  const auto& copy_of = scene_.chambers[owner.index].pillars[owner.pillar].copy_of;
  if (!copy_of) return surface;
  for (std::uint32_t i = 0;; ++i)
    if (world_.owner(i).kind == owner.kind && world_.owner(i).pillar == *copy_of) return i;
}

// The wall or that of its copies of which a place lies in the cell.
std::uint32_t Room::wall_in_cell(std::uint32_t surface, double position) const {
  for (std::uint32_t i = surface; has_copies_ && i < walls().size(); ++i)
    if (counted_[i] == surface && solids_.in_chamber(places_.point(i, position))) return i;
  return surface;
}

double Room::place_of(const Bounce& bounce) const {
  const std::uint32_t wall = bounce.surface;
  const auto& [first, other] = weights_[counted_[wall]];
  const bool second =
      other > 0 && (first == 0 || bounce.normal.dot(wall_normal(walls(), wall, bounce.point)) < 0);
  return before_[counted_[wall]] + (second ? other : first) * places_.position(wall, bounce.point) +
         (second ? first * places_.length(wall) : 0);
}

OrbitStart Room::draw_start_in(const Stretch& all, std::uint64_t seed, std::uint64_t number,
                               Starts starts) const {
  for (std::uint32_t attempt = 0;; attempt += 4) {
    // Where rounding leaves no place to start from, a draw that depends on no other is as good.
    const bool even = starts == Starts::quasi && attempt == 0;
    const UnitPoint at =
        even ? quasi_point(seed, number)
             : UnitPoint{drawn_unit(seed, number, attempt), drawn_unit(seed, number, attempt + 1)};
    const double along = all.from + at.x * (all.to - all.from), sine = 2 * at.y - 1;
    const auto above = std::upper_bound(before_.begin() + 1, before_.end() - 1, along);
    const auto drawn = static_cast<std::uint32_t>(above - before_.begin() - 1);
    const auto& [first, other] = weights_[drawn];
    const double length = first * places_.length(drawn), beyond = along - before_[drawn];
    const bool second = other > 0 && (first == 0 || beyond > length);  // the other side
    const double within = second ? (beyond - length) / other : beyond / first;
    const std::uint32_t surface = wall_in_cell(drawn, within);
    const Sign side = second ? Sign::negative : Sign::positive;
    const auto origin = in_front_of(walls(), surface, side, places_.point(surface, within));
    if (!origin) continue;
    if (has_copies_ && !solids_.in_chamber(*origin)) continue;
    const Vec2 normal = static_cast<double>(side) * wall_normal(walls(), surface, *origin);
    const Vec2 direction =
        std::sqrt((1 - sine) * (1 + sine)) * normal + sine * Vec2(-normal.y(), normal.x());
    if (!leads_away(walls(), surface, side, *origin, direction)) continue;
    const Root root =
        walls().visit(surface, [&](const auto& wall) { return root_departed(wall, side); });
    return {{*origin, direction}, {surface, root}, chance_of(seed, number)};
  }
}

OrbitStart Room::draw_free_start(std::uint64_t seed, std::uint64_t number) const {
  constexpr double kFullTurn = 0x1.921fb54442d18p+2;
  Bounds box;
  for (const Chamber& chamber : scene_.chambers)
    box.add(shape_bounds(scene_.shapes[chamber.shape], world_pose(state_)));
  for (std::uint32_t attempt = 0;; attempt += 3) {
    const auto draw = [&](std::uint32_t which) {
      return drawn_unit(seed, number, attempt + which);
    };
    const Vec2 place = box.low + Vec2(draw(0), draw(1)).cwiseProduct(box.size());
    if (!solids_.in_chamber(place) || solids_.holder(place)) continue;
    const double angle = kFullTurn * draw(2);
    return {{place, {portable::cos(angle), portable::sin(angle)}}, {}};
  }
}

Result<void> expect_walls(const ExperimentContext& context, const Room& room) {
  if (room.perimeter() > 0) return {};
  return fail(context.scene.where, "has no walls",
              "add a [[chamber]], or give entities material = \"mirror\"");
}

namespace {

template <class One, class Other>
bool lie_on_one_another(const One& one, const Other& other) {
  return overlap(one, other);
}
// The ends and radii of arcs by degrees are rounded: curves that differ by no more than that are one, and
// arcs that only share an end do not overlap.
bool lie_on_one_another(const Arc& one, Arc other) {
  constexpr double kRounding = 0x1p-50, kShorter = 0x1p-44;  // of the radius
  const Ellipse &a = one.curve, &b = other.curve;
  if (a.is_circle() && b.is_circle() && std::fabs(a.u.x() - b.u.x()) <= kRounding * a.u.x() &&
      (a.centre - b.centre).cwiseAbs().maxCoeff() <= kRounding * a.u.x())
    other.curve = a;
  const auto turned = [&](const Vec2& end, double by) {
    const Vec2 out = end - other.curve.centre;
    return Vec2(end + by * Vec2(-out.y(), out.x()));
  };
  if (other.extent == Arc::Extent::between) {
    other.from = turned(other.from, kShorter);
    other.to = turned(other.to, -kShorter);
  }
  return overlap(one, other);
}

// Walls that lie on one another count in the perimeter, and no orbit comes between them but into a
// slit of the chamber itself.
Result<void> expect_no_hidden_walls(const Scene& scene) {
  const World world = build_world(scene, at(Timeline(scene, scene.seed, 1), 1));
  const Surfaces& walls = world.surfaces;
  std::vector<Bounds> boxes;
  std::vector<bool> of_chamber;
  for (std::uint32_t wall = 0; wall < walls.size(); ++wall) {
    boxes.push_back(walls.visit(wall, [](const auto& one) { return bounds_of(one); }));
    of_chamber.push_back(world.owner(wall).kind == SurfaceOwner::Kind::chamber);
  }
  std::pair<std::uint32_t, std::uint32_t> first{kNoSurface, kNoSurface};
  const auto look = [&](std::uint32_t a, std::uint32_t b) {
    const auto is_hidden = [&](const auto& one) {
      return walls.visit(b, [&](const auto& other) { return lie_on_one_another(one, other); });
    };
    if (std::pair(a, b) < first && walls.visit(a, is_hidden)) first = {a, b};
    return true;
  };
  each_overlap(boxes, of_chamber, look);
  if (first.first == kNoSurface) return {};
  const bool is_second = world.owner(first.second).kind == SurfaceOwner::Kind::pillar;
  const SurfaceOwner &one = world.owner(is_second ? first.first : first.second),
                     &pillar = world.owner(is_second ? first.second : first.first);
  const bool alone = one.kind == pillar.kind && one.pillar == pillar.pillar;
  return fail(
      scene.chambers[pillar.index].pillars[pillar.pillar].where,
      fmt::format("a wall of {} lies on one of {}: no orbit comes between them",
                  owner_name(scene, pillar), alone ? "its own" : owner_name(scene, one)),
      alone
          ? "leave a gap, as a ring from 0 to 359.9 degrees has: such walls count in the perimeter"
          : "write both as one outline, or leave room between them: such walls count in "
            "the perimeter");
}

Result<void> expect_no_other_way_out(const ExperimentContext& context) {
  const Scene& scene = context.scene;
  if (scene.chambers.empty())
    return fail(scene.where, "has no chamber for orbits to stay in",
                "add [[chamber]] with a shape");
  const Chamber& chamber = scene.chambers.front();
  const Shape& shape = scene.shapes[chamber.shape];
  if (part_counts(shape).areas() == 0)
    return fail(
        chamber.where, "the chamber is open, and orbits leave it",
        "close its shape: a polygon, a circle, a capsule; lines and Bezier curves enclose nothing");
  if (chamber.material == Material::glass)
    return fail(chamber.where, "the chamber is of glass, and orbits leave it",
                "make it a mirror, and what stands in it glass");
  const auto absorbs = [](const auto& one) { return one.material == Material::absorb; };
  const auto pillar = std::ranges::find_if(chamber.pillars, absorbs);
  if (absorbs(chamber) || pillar != chamber.pillars.end())
    return fail(absorbs(chamber) ? chamber.where : pillar->where, "has walls that absorb",
                "all must be mirrors here");
  if (chamber.material == Material::periodic && chamber.pillars.empty())
    return fail(chamber.where, "has nothing to bounce off",
                "add pillars between the periodic walls");
  for (const Entity& entity : scene.entities)
    if (entity.material)
      return fail(entity.where, "rays meet this entity beside the chamber",
                  "write what stands in the chamber as its pillars: their areas count");
  if (auto inside = expect_pillars_inside(scene); !inside) return inside;
  if (auto apart = expect_pillars_apart(scene); !apart) return apart;
  return expect_no_hidden_walls(scene);
}

}  // namespace

Result<void> expect_closed(const ExperimentContext& context) {
  if (!context.scene.chambers.empty() && !context.scene.chambers.front().holes.empty())
    return fail(context.scene.chambers.front().holes.front().where,
                "the chamber has holes, and orbits leave it",
                context.scene.field() == 0 ? "ask for escape, recurrence or splitting"
                                           : "leave the holes out");
  return expect_no_other_way_out(context);
}

Result<void> expect_holes(const ExperimentContext& context) {
  const Scene& scene = context.scene;
  if (scene.chambers.empty())
    return fail(scene.where, "there is no chamber with holes to come back to");
  if (scene.chambers.front().holes.empty())
    return fail(scene.chambers.front().where, "the chamber has no holes to come back to",
                "add holes = [{ edge = 0, from = 0.4, to = 0.5 }]");
  return expect_no_other_way_out(context);
}

Result<void> expect_not_periodic(const ExperimentContext& context) {
  for (const Chamber& chamber : context.scene.chambers)
    if (chamber.material == Material::periodic)
      return fail(chamber.where, "this experiment knows no periodic walls",
                  "leave material = \"periodic\" out");
  return {};
}

std::string owner_name(const Scene& scene, const SurfaceOwner& owner) {
  if (owner.kind == SurfaceOwner::Kind::entity) return entity_name(scene, owner.index);
  if (owner.kind == SurfaceOwner::Kind::chamber) return chamber_name(scene, owner.index);
  return name_or_number(scene.chambers[owner.index].pillars[owner.pillar].name, "pillar",
                        owner.pillar);
}

Result<NamedOrbits> orbits_to_watch(const ExperimentContext& context, const Room& room,
                                    std::uint64_t random_orbits) {
  if (auto walls = expect_walls(context, room); !walls) return fail(std::move(walls));
  NamedOrbits orbits;
  Diagnostics outside;
  for (const RayState& state : ray_states(context.scene, room.state())) {
    const RayPath& ray = context.scene.rays[state.ray];
    if (!room.has_start(state.start.origin))
      outside.push_back({ray.where, called("ray", ray.name, ray.where) + " starts outside the room",
                         "let it start in the chamber, and in none of its pillars",
                         Trouble::invalid});
    orbits.names.push_back(ray_name(context.scene, state.ray));
    orbits.starts.push_back({state.start, {}, chance_of_orbit(context.seed, state.ray)});
  }
  if (!outside.empty()) return tl::unexpected(std::move(outside));
  if (!orbits.starts.empty() && context.starts != Starts::random)
    return fail(context.scene.rays.front().where,
                "orbits are those of the scene's rays, none are drawn",
                "leave --starts out, or the rays");
  if (!orbits.starts.empty()) return orbits;
  orbits.random = true;
  for (std::uint64_t i = 0; i < random_orbits; ++i) {
    const bool even = context.starts == Starts::quasi;
    orbits.names.push_back(fmt::format("{} {}", even ? "quasi" : "random", i + 1));
    orbits.starts.push_back(room.draw_start(context.seed, even ? i * kShifts : i, context.starts));
  }
  return orbits;
}

Result<OrbitPlan> plan_orbits(const ExperimentContext& context, std::uint64_t usual_bounces) {
  constexpr std::uint64_t kUsualOrbits = 16;  // at least: their differences are the error
  const std::uint64_t few = (context.count + kUsualOrbits - 1) / kUsualOrbits;
  const std::uint64_t bounces = context.bounces.value_or(std::min(usual_bounces, few));
  if (bounces == 0)
    return refused_option("--bounces", "an orbit without bounces measures nothing",
                          "say 1 or more");
  if (context.count <= bounces)
    return refused_option("--count", "one orbit alone has no error",
                          fmt::format("say more than the {} of an orbit", bounces));
  const OrbitPlan plan{(context.count + bounces - 1) / bounces, bounces};
  if (context.starts == Starts::quasi && plan.orbits < 2 * kShifts)
    return refused_option(
        "--count",
        fmt::format("quasi-random starts in {} shifts need more than {}", kShifts,
                    counted(plan.orbits, "orbit")),
        fmt::format("say --count {} or more, or fewer --bounces", 2 * kShifts * bounces));
  return plan;
}

}  // namespace flatray
