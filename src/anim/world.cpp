#include "anim/world.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "geom/hit_interval.h"
#include "geom/predicates.h"
#include "scene/outlines/outline.h"
#include "scene/outlines/rounded.h"

namespace flatray {
namespace {

void add_segment(World& world, const Vec2& a, const Vec2& b, const SurfaceOwner& owner) {
  if (a == b) return;  // so small and so far away that the doubles do not tell its ends apart
  world.add(Segment{a, b}, owner);
}

// Between the points at which it is drawn to begin and end, so that what is joined to it has no gap.
PathEdge arc_in_world(const PathWall& wall, const Pose& place) {
  const EllipseArc& arc = *wall.arc;
  const Vec2 from = place(wall.from), to = place(wall.to);
  const Ellipse curve = curve_of(arc, place);
  const bool is_flat = cross_sign(curve.u, curve.v) == Sign::zero;
  // So small, and so far away, that the doubles do not tell the directions of its ends apart.
  const bool ends_alike =
      !is_flat && !arc.is_whole() && lie_in_one_direction(curve.centre, from, to);
  const bool whole = arc.is_whole() || (ends_alike && std::abs(arc.sweep) > std::numbers::pi);
  if (is_flat && whole) {
    const Vec2 reach =
        curve.u.cwiseAbs().maxCoeff() > curve.v.cwiseAbs().maxCoeff() ? curve.u : curve.v;
    return {curve.centre - reach, curve.centre + reach, std::nullopt};
  }
  if (!whole && (is_flat || ends_alike)) return {from, to, std::nullopt};
  const bool forward = (arc.sweep > 0) == (cross_sign(arc.u, arc.v) == Sign::positive);
  if (whole) return {from, to, Arc{curve, Arc::Extent::whole, {0, 0}, {0, 0}, !forward}, forward};
  return {from, to,
          Arc{curve, Arc::Extent::between, forward ? from : to, forward ? to : from, !forward},
          forward};
}

PathEdge in_world(const PathWall& wall, const Pose& place) {
  return wall.arc ? arc_in_world(wall, place)
                  : PathEdge{place(wall.from), place(wall.to), std::nullopt};
}

void add_edge(World& world, const PathEdge& edge, const SurfaceOwner& owner) {
  if (edge.arc)
    world.add(*edge.arc, owner);
  else
    add_segment(world, edge.from, edge.to, owner);
}

void add_path(World& world, const ArcPath& path, const Pose& place, SurfaceOwner owner) {
  for (const PathEdge& edge : path_in_world(path, place).edges) {
    owner.edge = edge.number;
    add_edge(world, edge, owner);
  }
}

// The walls of a chamber, cut where it has holes.
void add_walls(World& world, const Scene& scene, std::uint32_t chamber, const Pose& place) {
  const Chamber& room = scene.chambers[chamber];
  SurfaceOwner owner{SurfaceOwner::Kind::chamber, chamber, 0, kNoEdge, room.material};
  if (room.parts.empty()) return add_shape(world, scene.shapes[room.shape], place, owner);
  for (const WallPiece& part : room.parts) {
    owner.edge = part.edge;
    owner.hole = part.hole;
    owner.turned = part.turned;
    owner.material = part.hole == kNoEntry ? room.material : Material::hole;
    add_edge(world, in_world(part.wall, place), owner);
  }
}

}  // namespace

void add_shape(World& world, const Shape& shape, const Pose& place, SurfaceOwner owner) {
  for (const OutlineEdge& edge : outline(shape)) {
    owner.edge = edge.number;
    owner.turned = edge.turned;
    add_segment(world, place(shape.vertices[edge.from]), place(shape.vertices[edge.to]), owner);
  }
  owner.edge = 0;
  owner.turned = false;
  for (const Segment& segment : shape.segments) {
    add_segment(world, place(segment.a), place(segment.b), owner);
    ++owner.edge;
  }
  for (const Bezier& curve : shape.beziers) {
    const Bezier there = mapped(curve, place);
    if (is_on_one_line(there)) {  // so small and so far away
      const Segment flat = stretch_of(there);
      add_segment(world, flat.a, flat.b, owner);
    } else {
      world.add(there, owner);
    }
    ++owner.edge;
  }
  owner.edge = kNoEdge;
  for (const Circle& circle : shape.circles) world.add(posed(circle, place), owner);
  for (const ArcPath& path : shape.arc_paths) add_path(world, path, place, owner);
}

Ellipse curve_of(const EllipseArc& arc, const Pose& place) {
  if (arc.is_circular()) return posed(Circle{arc.centre, circle_radius(arc.u)}, place);
  return {place(arc.centre), place.turned(arc.u), place.turned(arc.v)};
}

CurvedPath path_in_world(const ArcPath& path, const Pose& place) {
  CurvedPath there{{}, path.closed};
  for (const PathWall& wall : walls_of(path)) {
    there.edges.push_back(in_world(wall, place));
    there.edges.back().number = static_cast<int>(there.edges.size()) - 1;
  }
  return there;
}

std::vector<Material> World::materials() const {
  std::vector<Material> all;
  for (const SurfaceOwner& owner : owners) all.push_back(owner.material);
  return all;
}

std::vector<const Scatterer*> scatterers_of(const Scene& scene, const World& world) {
  using Kind = SurfaceOwner::Kind;
  std::vector<const Scatterer*> all;
  for (const SurfaceOwner& owner : world.owners) {
    const ScattererId id = owner.hole != kNoEntry       ? kNoEntry
                           : owner.kind == Kind::entity ? scene.entities[owner.index].scatterer
                           : owner.kind == Kind::chamber
                               ? scene.chambers[owner.index].scatterer
                               : scene.chambers[owner.index].pillars[owner.pillar].scatterer;
    all.push_back(id == kNoEntry ? nullptr : scene.scatterers[id].get());
  }
  return all;
}

namespace {

// So many worlds that all shapes of either come equally often; where those would be many, nearly.
std::size_t common(std::size_t a, std::size_t b) {
  constexpr std::size_t kMostWorlds = 1024;
  const std::size_t both = std::lcm(a, b);
  return both <= kMostWorlds ? both : std::max(a, b);
}

bool belongs_alike(const SurfaceOwner& a, const SurfaceOwner& b) {
  return a.kind == b.kind && a.index == b.index && a.pillar == b.pillar;
}

}  // namespace

std::size_t count_of_worlds(const Scene& scene) {
  std::size_t count = 1;
  for (const Entity& entity : scene.entities) count = common(count, entity.alternatives.size() + 1);
  return count;
}

std::vector<World> alternative_worlds(const Scene& scene, const FrameState& state) {
  const std::size_t count = count_of_worlds(scene);
  std::vector<World> worlds{build_world(scene, state)};
  FrameState other = state;
  for (std::size_t k = 1; k < count; ++k) {
    for (std::size_t i = 0; i < scene.entities.size(); ++i)
      if (const auto& shapes = scene.entities[i].alternatives; !shapes.empty()) {
        const std::size_t which = k % (shapes.size() + 1);
        other.entities[i].shape = which == 0 ? state.entities[i].shape : shapes[which - 1];
      }
    World world = build_world(scene, other);
    // So far away that the doubles do not tell the ends of one apart: it is left out.
    if (std::equal(world.owners.begin(), world.owners.end(), worlds.front().owners.begin(),
                   worlds.front().owners.end(), belongs_alike))
      worlds.push_back(std::move(world));
  }
  return worlds;
}

World build_world(const Scene& scene, const FrameState& state, WorldOf of) {
  using Kind = SurfaceOwner::Kind;
  World world;
  for (std::uint32_t i = 0; i < scene.entities.size(); ++i) {
    const std::optional<Material> material = scene.entities[i].material;
    if (state.entities[i].gone) continue;
    if (material || of == WorldOf::everything)
      add_shape(world, shape_of(scene, state.entities[i]), entity_pose(state, i),
                {Kind::entity, i, 0, kNoEdge, material.value_or(Material::absorb)});
  }
  for (std::uint32_t i = 0; i < scene.chambers.size(); ++i) {
    const Chamber& chamber = scene.chambers[i];
    add_walls(world, scene, i, world_pose(state));
    for (std::uint32_t j = 0; j < chamber.pillars.size(); ++j)
      add_shape(world, scene.shapes[chamber.pillars[j].shape],
                pillar_pose(state, chamber.pillars[j]),
                {Kind::pillar, i, j, kNoEdge, chamber.pillars[j].material});
  }
  return world;
}

}  // namespace flatray
