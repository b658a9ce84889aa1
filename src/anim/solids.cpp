#include "anim/solids.h"

#include <algorithm>

#include "geom/hit_interval.h"
#include "geom/predicates.h"
#include "trace/on_surface.h"

namespace flatray {
namespace {

constexpr double kPi = 0x1.921fb54442d18p+1;

bool holds(const std::vector<Vec2>& convex, const Vec2& point) {
  for (std::size_t i = 0; i < convex.size(); ++i)
    if (orientation(convex[i], convex[(i + 1) % convex.size()], point) == Sign::negative)
      return false;
  return true;
}

double area_of(const std::vector<Vec2>& ring) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i)
    twice += cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
  return 0.5 * twice;
}

}  // namespace

bool Solids::Solid::holds(const Vec2& point) const {
  return std::any_of(pieces.begin(), pieces.end(),
                     [&](const auto& piece) { return flatray::holds(piece, point); }) ||
         std::any_of(circles.begin(), circles.end(), [&](const Circle& circle) {
           return curve_side(point, circle) != Sign::positive;
         });
}

double Solids::Solid::area() const {
  double sum = 0;
  for (const std::vector<Vec2>& piece : pieces) sum += area_of(piece);
  for (const Circle& circle : circles) sum += kPi * circle.radius * circle.radius;
  return sum;
}

Solids::Solid Solids::solid(const Shape& shape, const Pose& place, const SurfaceOwner& owner) {
  Solid solid{owner, {}, {}};
  for (std::size_t i = 0; i < shape.piece_count(); ++i) {
    std::vector<Vec2> piece;
    for (std::uint32_t k = shape.begin[i]; k < shape.begin[i + 1]; ++k)
      piece.push_back(place(shape.vertices[k]));
    solid.pieces.push_back(std::move(piece));
  }
  for (const Circle& circle : shape.circles)
    solid.circles.push_back({place(circle.centre), circle.radius});
  return solid;
}

Solids::Solids(const Scene& scene, const FrameState& state) {
  using Kind = SurfaceOwner::Kind;
  for (std::uint32_t i = 0; i < scene.entities.size(); ++i)
    if (const std::optional<Material> material = scene.entities[i].material)
      obstacles_.push_back(solid(scene.shapes[state.entities[i].shape], entity_pose(state, i),
                                 {Kind::entity, i, 0, kNoEdge, *material}));
  for (std::uint32_t i = 0; i < scene.chambers.size(); ++i) {
    const Chamber& chamber = scene.chambers[i];
    chambers_.push_back(solid(scene.shapes[chamber.shape], world_pose(state),
                              {Kind::chamber, i, 0, kNoEdge, chamber.material}));
    for (std::uint32_t j = 0; j < chamber.pillars.size(); ++j)
      obstacles_.push_back(solid(scene.shapes[chamber.pillars[j].shape],
                                 pillar_pose(state, chamber.pillars[j]),
                                 {Kind::pillar, i, j, kNoEdge, chamber.pillars[j].material}));
  }
}

std::optional<SurfaceOwner> Solids::holder(const Vec2& point) const {
  const auto found = std::find_if(obstacles_.begin(), obstacles_.end(),
                                  [&](const Solid& solid) { return solid.holds(point); });
  return found == obstacles_.end() ? std::nullopt : std::optional(found->owner);
}

bool Solids::in_chamber(const Vec2& point) const {
  return chambers_.empty() || std::any_of(chambers_.begin(), chambers_.end(),
                                          [&](const Solid& solid) { return solid.holds(point); });
}

double Solids::free_area() const {
  double sum = 0;
  for (const Solid& chamber : chambers_) sum += chamber.area();
  for (const Solid& obstacle : obstacles_)
    if (obstacle.owner.kind == SurfaceOwner::Kind::pillar) sum -= obstacle.area();
  return sum;
}

}  // namespace flatray
