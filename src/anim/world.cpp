#include "anim/world.h"

#include "geom/hit_interval.h"
#include "scene/outline.h"

namespace flatray {
namespace {

void add_segment(World& world, const Vec2& a, const Vec2& b, const SurfaceOwner& owner) {
  if (a == b) return;  // so small and so far away that the doubles do not tell its ends apart
  world.surfaces.add(Segment{a, b});
  world.owners.push_back(owner);
}

void add_shape(World& world, const Shape& shape, const Pose& place, SurfaceOwner owner) {
  for (const OutlineEdge& edge : outline(shape)) {
    owner.edge = edge.number;
    add_segment(world, place(shape.vertices[edge.from]), place(shape.vertices[edge.to]), owner);
  }
  owner.edge = 0;
  for (const Segment& segment : shape.segments) {
    add_segment(world, place(segment.a), place(segment.b), owner);
    ++owner.edge;
  }
  owner.edge = kNoEdge;
  for (const Circle& circle : shape.circles) {
    world.surfaces.add(Circle{place(circle.centre), circle.radius});
    world.owners.push_back(owner);
  }
}

}  // namespace

std::vector<Material> World::materials() const {
  std::vector<Material> all;
  for (const SurfaceOwner& owner : owners) all.push_back(owner.material);
  return all;
}

World build_world(const Scene& scene, const FrameState& state, WorldOf of) {
  using Kind = SurfaceOwner::Kind;
  World world;
  for (std::uint32_t i = 0; i < scene.entities.size(); ++i) {
    const std::optional<Material> material = scene.entities[i].material;
    if (material || of == WorldOf::everything)
      add_shape(world, scene.shapes[state.entities[i].shape], entity_pose(state, i),
                {Kind::entity, i, 0, kNoEdge, material.value_or(Material::absorb)});
  }
  for (std::uint32_t i = 0; i < scene.chambers.size(); ++i) {
    const Chamber& chamber = scene.chambers[i];
    add_shape(world, scene.shapes[chamber.shape], world_pose(state),
              {Kind::chamber, i, 0, kNoEdge, chamber.material});
    for (std::uint32_t j = 0; j < chamber.pillars.size(); ++j)
      add_shape(world, scene.shapes[chamber.pillars[j].shape],
                pillar_pose(state, chamber.pillars[j]),
                {Kind::pillar, i, j, kNoEdge, chamber.pillars[j].material});
  }
  return world;
}

}  // namespace flatray
