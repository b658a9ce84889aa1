#pragma once
#include <optional>
#include <vector>

#include "trace/hits.h"
#include "trace/surfaces.h"
#include "trace/wall_cells.h"
#include "transport/field_meeting.h"
#include "transport/hit_point.h"

namespace flatray {

/// Where a ray goes on from after a hit: the rounded point of its wall.
struct ExactOrigin {
  Vec2 point;  ///< where the ray goes on from; at a corner the nearest double
  std::vector<std::uint32_t>
      corner;  ///< the walls that meet there, ascending; empty where it can be reflected
  Vec2 normal{0,
              0};  ///< where it can be: of the wall, to the left of a segment, outward of a curve
};

/// On which side of a wall: where the ray comes from, or beyond.
enum class GoesOn : std::uint8_t { back, through };

/// Rounds hits so that nothing leaks. Of the doubles at most 2 ulp off in each coordinate it takes
/// the nearest that lies on the closed side of the wall to which the ray goes on, lies on no other
/// wall, and lies on the side of the exact hit of every wall that passes there. A hit is a corner
/// where there is no such double, at an end of its wall, and on another wall.
class ExactOrigins {
 public:
  /// Needs   `walls` to outlive it.
  explicit ExactOrigins(const Surfaces& walls);

  /// Needs   a hit by `ray` that is not a tangent of a curve.
  /// Cost    a look at the walls of a cell; some 100 us for each wall within a few ulps of the point.
  ExactOrigin after(const Ray& ray, const NearestHit& hit, GoesOn to = GoesOn::back) const;
  /// The same of a flight in a field.
  ExactOrigin after(const FieldFlight& flight, const FieldHit& hit) const;
  /// Where what stands at a point beside a wall, on one side of it, stands on the other: the nearest double
  /// on the same side of all other walls; none where there is none.
  std::optional<Vec2> across(const Vec2& point, std::uint32_t surface, Sign from) const;
  /// The walls on which a point stands, ascending. Exact.
  std::vector<std::uint32_t> walls_at(const Vec2& point) const;
  /// How the walls are kept.
  const WallCells& cells() const { return cells_; }

 private:
  struct NearWall;
  std::optional<ExactOrigin> quick_after(const Ray& ray, const NearestHit& hit,
                                         const QuickHit& quick, GoesOn to) const;
  Vec2 normal_at(const Ray& ray, const NearestHit& hit, const QuickHit& quick) const;
  std::vector<std::uint32_t> walls_near(const Vec2& point, std::uint32_t hit) const;
  ExactOrigin at_end(const Vec2& end, std::uint32_t surface) const;
  template <class Exact>
  ExactOrigin with_met(ExactOrigin origin, const Exact& exact, std::uint32_t surface) const;
  bool may_stand(const Vec2& point, std::uint32_t hit, Sign outer,
                 const std::vector<NearWall>& near) const;
  template <class Exact>
  NearWall near_wall(std::uint32_t surface, const Exact& hit) const;
  template <class Exact>
  ExactOrigin beside_others(const Exact& exact, std::uint32_t surface, Sign outer) const;

  const Surfaces& walls_;
  WallCells cells_;
};

/// Whether a point is an end of a wall. Exact.
bool is_end(const Surfaces& walls, std::uint32_t surface, const Vec2& point);

/// The side of its wall a ray comes from: left (positive) of a segment, outside (positive) of a
/// curve.
Sign inner_side(const Surfaces& walls, const Ray& ray, const NearestHit& hit);

/// Whether a ray to a place, which it comes to at t = 1 but for rounding, meets a wall before it: by the sides
/// of the wall that it comes from and that the place is on, where t leaves a doubt; of a segment that it runs
/// along, by whether that begins before the place.
bool is_before(const Surfaces& walls, const Ray& ray, const NearestHit& hit, const Vec2& place);

}  // namespace flatray
