#include "anim/solids.h"

#include <algorithm>
#include <numbers>

#include "geom/hit_interval.h"
#include "geom/polygon.h"
#include "trace/exact_nearest.h"

namespace flatray {
namespace {

// Whether a point lies inside or on closed outlines: by the parity of what a ray from it meets, in a
// direction in which it meets no end and no tangent.
bool is_within(const Surfaces& outline, const Vec2& point) {
  if (outline.size() == 0) return false;
  for (double turn = 1;; turn += 1) {
    ExactNearest every(outline, {point, {turn, 1}}, {}, true, true);
    every.offer_all();
    const std::vector<NearestHit> hits = every.hits();
    if (!hits.empty() && hits.front().t == 0) return true;
    const bool doubtful = std::ranges::any_of(hits, [](const NearestHit& hit) {
      return hit.at_end || hit.root == Root::both || hit.kind == HitClass::along;
    });
    if (!doubtful) return hits.size() % 2 == 1;
  }
}

// By Green's theorem; an ellipse is c + cos t u + sin t v.
double area_of(const ArcPath& path) {
  double twice = 0;
  for (std::size_t i = 0; i < path.arcs.size(); ++i) {
    const EllipseArc& arc = path.arcs[i];
    const Vec2 next = path.arcs[(i + 1) % path.arcs.size()].start();
    twice += cross(arc.centre, Vec2(arc.end() - arc.start())) + cross(arc.u, arc.v) * arc.sweep +
             cross(arc.end(), next);
  }
  return std::fabs(0.5 * twice);
}

}  // namespace

bool Solids::Solid::holds(const Vec2& point) const {
  return std::ranges::any_of(pieces,
                             [&](const auto& piece) {
                               return place_in_convex(point, piece) != StartPlace::outside;
                             }) ||
         std::ranges::any_of(
             circles,
             [&](const Circle& circle) { return curve_side(point, circle) != Sign::positive; }) ||
         is_within(outline.surfaces, point);
}

double Solids::Solid::area() const {
  double sum = 0;
  for (const std::vector<Vec2>& piece : pieces) sum += ring_area(piece);
  for (const Circle& circle : circles) sum += std::numbers::pi * circle.radius * circle.radius;
  for (const ArcPath& path : paths) sum += area_of(path);
  return sum;
}

Solids::Solid Solids::solid(const Shape& shape, const Pose& place, const SurfaceOwner& owner) {
  Solid solid{owner, {}, {}, {}, {}, false};
  for (std::size_t i = 0; i < shape.piece_count(); ++i)
    solid.pieces.push_back(posed_piece(shape, i, place));
  for (const Circle& circle : shape.circles) solid.circles.push_back(posed(circle, place));
  Shape curved;
  for (const ArcPath& path : shape.arc_paths) {
    if (!path.closed) continue;
    curved.arc_paths.push_back(path);
    solid.paths.push_back(posed(path, place));
  }
  add_shape(solid.outline, curved, place, owner);
  return solid;
}

Solids::Solids(const Scene& scene, const FrameState& state) {
  using Kind = SurfaceOwner::Kind;
  for (std::uint32_t i = 0; i < scene.entities.size(); ++i)
    if (const std::optional<Material> material = scene.entities[i].material;
        material && !state.entities[i].gone)
      obstacles_.push_back(solid(shape_of(scene, state.entities[i]), entity_pose(state, i),
                                 {Kind::entity, i, 0, kNoEdge, *material}));
  for (std::uint32_t i = 0; i < scene.chambers.size(); ++i) {
    const Chamber& chamber = scene.chambers[i];
    chambers_.push_back(solid(scene.shapes[chamber.shape], world_pose(state),
                              {Kind::chamber, i, 0, kNoEdge, chamber.material}));
    for (std::uint32_t j = 0; j < chamber.pillars.size(); ++j) {
      obstacles_.push_back(solid(scene.shapes[chamber.pillars[j].shape],
                                 pillar_pose(state, chamber.pillars[j]),
                                 {Kind::pillar, i, j, kNoEdge, chamber.pillars[j].material}));
      obstacles_.back().copy = chamber.pillars[j].copy_of.has_value();
    }
  }
}

std::optional<SurfaceOwner> Solids::holder(const Vec2& point) const {
  const auto found =
      std::ranges::find_if(obstacles_, [&](const Solid& solid) { return solid.holds(point); });
  return found == obstacles_.end() ? std::nullopt : std::optional(found->owner);
}

bool Solids::in_chamber(const Vec2& point) const {
  return chambers_.empty() || std::ranges::any_of(chambers_, [&](const Solid& solid) {
           const bool lines = solid.pieces.empty() && solid.circles.empty() && solid.paths.empty();
           return lines || solid.holds(point);
         });
}

double Solids::free_area() const {
  double sum = 0;
  for (const Solid& chamber : chambers_) sum += chamber.area();
  for (const Solid& obstacle : obstacles_)
    if (obstacle.owner.kind == SurfaceOwner::Kind::pillar && !obstacle.copy) sum -= obstacle.area();
  return sum;
}

double Solids::pillar_area(std::uint32_t chamber, std::uint32_t pillar) const {
  for (const Solid& one : obstacles_)
    if (one.owner.kind == SurfaceOwner::Kind::pillar && one.owner.index == chamber &&
        one.owner.pillar == pillar)
      return one.area();
  return 0;
}

}  // namespace flatray
