#include "collide/pillars.h"

#include <fmt/core.h>

#include <algorithm>

#include "anim/solids.h"
#include "base/number_text.h"
#include "collide/broad_phase.h"
#include "collide/outline_contact.h"
#include "scene/outlines/lattice_cell.h"
#include "scene/outlines/outline.h"
#include "scene/part_counts.h"

namespace flatray {
namespace {

// Points of it, in the world: one of what crosses the walls where it is not wholly in or out, and of
// lone segments both ends, as two of those have no inner point in common.
std::vector<Vec2> points_of(const Shape& shape, const Pose& place) {
  std::vector<Vec2> points;
  if (!shape.vertices.empty()) points.push_back(place(shape.vertices.front()));
  if (!shape.circles.empty()) points.push_back(place(shape.circles.front().centre));
  if (!shape.arc_paths.empty())
    points.push_back(place(shape.arc_paths.front().arcs.front().start()));
  for (const Segment& segment : shape.segments) {
    points.push_back(place(segment.a));
    points.push_back(place(segment.b));
  }
  for (const Bezier& curve : shape.beziers) {
    points.push_back(place(curve.start()));
    points.push_back(place(curve.end()));
  }
  return points;
}

// The straight walls of a chamber, without its inside.
Shape straight_walls(const Shape& chamber) {
  Shape walls;
  for (const OutlineEdge& edge : outline(chamber))
    walls.segments.push_back({chamber.vertices[edge.from], chamber.vertices[edge.to]});
  return walls;
}

bool overlap(const MovingShape& a, const MovingShape& b) {
  if (part_counts(*a.shape).areas() + part_counts(*b.shape).areas() == 0) return false;
  const std::vector<MeetingPart> parts = shapes_meet(a, b, {0, 0});
  return std::ranges::any_of(
      parts, [](const MeetingPart& part) { return part.kind == HitClass::through; });
}

constexpr const char* kMovePillar =
    "move it, or make it smaller: the room's area and walls would be wrong";

std::string named(const Chamber::Pillar& pillar) {
  const std::string name =
      pillar.name.empty() ? "a pillar" : fmt::format("pillar '{}'", pillar.name);
  return pillar.copy_of ? "the copy of " + name : name;
}

// The pillars of a chamber as they stand.
std::vector<MovingShape> pillar_bodies(const Scene& scene, const Chamber& chamber,
                                       const FrameState& state) {
  std::vector<MovingShape> bodies;
  for (const Chamber::Pillar& pillar : chamber.pillars)
    bodies.push_back({&scene.shapes[pillar.shape], pillar_pose(state, pillar), {0, 0}});
  return bodies;
}

FrameState first_frame(const Scene& scene) { return at(Timeline(scene, scene.seed, 1), 1); }

}  // namespace

Result<void> expect_pillars_inside(const Scene& scene) {
  const FrameState state = first_frame(scene);
  const Solids solids(scene, state);
  for (const Chamber& chamber : scene.chambers) {
    const Shape walls = straight_walls(scene.shapes[chamber.shape]);
    const std::vector<MovingShape> bodies = pillar_bodies(scene, chamber, state);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (chamber.pillars[i].across) continue;
      const std::vector<Vec2> points = points_of(*bodies[i].shape, bodies[i].place);
      const bool stands_in =
          std::ranges::all_of(points, [&](const Vec2& point) { return solids.in_chamber(point); });
      if (!stands_in || overlap({&walls, world_pose(state), {0, 0}}, bodies[i]))
        return fail(chamber.pillars[i].where,
                    named(chamber.pillars[i]) + " does not stand in the chamber", kMovePillar);
    }
  }
  return {};
}

Result<void> expect_pillars_apart(const Scene& scene) {
  const FrameState state = first_frame(scene);
  for (const Chamber& chamber : scene.chambers) {
    const std::vector<MovingShape> bodies = pillar_bodies(scene, chamber, state);
    std::vector<Bounds> boxes;
    boxes.reserve(bodies.size());
    for (const MovingShape& body : bodies) boxes.push_back(shape_bounds(*body.shape, body.place));
    for (const auto& [a, b] : overlapping_pairs(boxes))
      if (overlap(bodies[a], bodies[b]))
        return fail(
            chamber.pillars[b].where,
            fmt::format("{} overlaps {}", named(chamber.pillars[b]), named(chamber.pillars[a])),
            kMovePillar);
    for (const Chamber::Pillar& pillar : chamber.pillars)
      if (pillar.across && scene.shapes[pillar.shape].circles.front().radius >
                               cell_depth(scene.shapes[chamber.shape]))
        return fail(
            pillar.where, named(pillar) + " reaches over more cells than those that are looked at",
            "write lattice vectors closer to a right angle: those of the same lattice will do");
  }
  return {};
}

}  // namespace flatray
