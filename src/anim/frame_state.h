#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "anim/timeline.h"
#include "geom/primitives/wall.h"

namespace flatray {

/// Where an entity is in one frame and how it looks.
struct EntityState {
  Vec2 at{0, 0};
  double angle = 0;
  double scale = 1;  ///< of the groups it stands in
  ShapeId shape = 0;
  std::shared_ptr<const Shape> changed{};  ///< what it is now, where it changes: see shape_of
  std::optional<Paint> fill;
  std::optional<Stroke> stroke;
  double opacity = 1;
  std::optional<StateId> state;  ///< of its Markov chain
  std::uint32_t sub_state = 0;
  bool gone = false;  ///< it has been removed: neither seen nor met
};

/// One frame: a function of (scene, frame) alone, so frame 17 by itself equals frame 17 of the run.
struct FrameState {
  unsigned frame = 1;  ///< from 1
  double time = 0;     ///< (frame - 1) / fps seconds
  std::vector<EntityState> entities;
  std::vector<Timeline::MarkovFrame> lamps{};  ///< by lamp, of its chain; empty where none has one
  Bounds window;                               ///< world shown, of the film's aspect
  /// Added to every world position where the camera moves objects instead of itself.
  Vec2 displaced{0, 0};
};

/// The shape of an entity in the frame.
inline const Shape& shape_of(const Scene& scene, const EntityState& entity) {
  return entity.changed ? *entity.changed : scene.shapes[entity.shape];
}

/// State at frame k in [1, last frame of the timeline].
FrameState at(const Timeline& timeline, unsigned frame);

/// Its entities alone, before the camera displaces anything; at a part in [0, 1) of the time from a
/// frame to the next, with the looks of the frame.
/// Needs   with a part above 0 a timeline without responses, and not its last frame.
std::vector<EntityState> entity_states(const Timeline& timeline, unsigned frame, double part = 0);

/// Kept where the scene's own coordinates must be, within kFarthest; so written that a NaN is, too.
inline double held(double v) {
  return v > -kFarthest ? (v < kFarthest ? v : kFarthest) : -kFarthest;
}
inline Vec2 held(const Vec2& point) { return {held(point.x()), held(point.y())}; }

/// Point of an entity's own coordinates in the world of the frame: at + scale * R(angle) * local.
struct Pose {
  Vec2 at;
  double cos = 1, sin = 0;
  double scale = 1;
  Vec2 operator()(const Vec2& local) const {
    if (sin == 0 && cos == 1 && scale == 1) return at + local;  // keeps dyadic positions dyadic
    return at + turned(local);
  }
  /// A difference of points.
  Vec2 turned(const Vec2& local) const {
    const Vec2 there(cos * local.x() - sin * local.y(), sin * local.x() + cos * local.y());
    return scale == 1 ? there : held(scale * there);
  }
  double length(double local) const { return scale == 1 ? local : held(scale * local); }
};
/// Multiples of 90 degrees turn exactly, as in geom/turn.h.
Pose pose(const Vec2& at, double angle, double scale = 1);

/// The same with the frame's displacement: of an entity, of a pillar, and of what stands in world
/// coordinates (chambers, rays). Everything drawn or traced goes through one of these three.
Pose entity_pose(const FrameState& state, std::size_t entity);
Pose pillar_pose(const FrameState& state, const Chamber::Pillar& pillar);
Pose world_pose(const FrameState& state);

/// Vertices of a convex piece of a shape in the world, convex as they are rounded: one that comes to lie
/// inside lies on the one before it.
std::vector<Vec2> posed_piece(const Shape& shape, std::size_t piece, const Pose& place);
/// Points, circles and arcs in the world.
inline Vec2 posed(const Vec2& point, const Pose& place) { return place(point); }
Circle posed(const Circle& circle, const Pose& place);
ArcPath posed(ArcPath path, const Pose& place);

/// Box that holds a shape, without its stroke, whose points, circles and paths posed(what, place) puts
/// where they are: a Pose, or one beyond the world. Empty for a shape without content. Of Bezier curves
/// `box_of` tells the box.
template <class Place, class BoxOf = Bounds (*)(const Bezier&)>
Bounds shape_bounds(const Shape& shape, const Place& place, const BoxOf& box_of = &bounds_of) {
  Bounds box;
  const auto add = [&](const Vec2& point) { box.add(posed(point, place)); };
  for (const Vec2& vertex : shape.vertices) add(vertex);
  for (const auto& ring : shape.crossing_rings)
    for (const Vec2& vertex : ring) add(vertex);
  for (const Segment& segment : shape.segments) add(segment.a), add(segment.b);
  for (const Circle& circle : shape.circles) {
    const Circle there = posed(circle, place);
    const Vec2 reach(there.radius, there.radius);
    box.add(Bounds{there.centre - reach, there.centre + reach});
  }
  for (const ArcPath& path : shape.arc_paths) box.add(path_bounds(posed(path, place)));
  for (const Bezier& curve : shape.beziers)
    box.add(box_of(mapped(curve, [&](const Vec2& point) { return posed(point, place); })));
  return box;
}

/// The same around what is seen of it: of Bezier curves around the curves themselves.
inline Bounds shape_extent(const Shape& shape, const Pose& place) {
  return shape_bounds(shape, place, &extent_of);
}

}  // namespace flatray
