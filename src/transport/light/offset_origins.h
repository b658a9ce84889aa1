#pragma once
#include <optional>
#include <span>
#include <vector>

#include "geom/bounds.h"
#include "trace/hits.h"
#include "trace/surfaces.h"

namespace flatray {

/// Doubles beside a wall from which rays go on after a hit: off the wall by far more than rounding can
/// move them, and far nearer to the hit than any other wall is, so that no wall lies between the two.
///
/// The double nearest to a hit lies on either side of its wall by chance, and to find one that is on
/// the right side of all walls near it is the work of ExactOrigins (transport/exact_origin.h). Light needs no
/// nearest double, and nearly all of its hits are far from corners.
///
/// Units   S is the largest coordinate of all walls, of arcs' whole curves too.
/// Error   a hit is off by less than 2^-46 S, an origin by 2^-44 S more; no other wall comes within
///         2^-36 S of them. Derived in docs/adr/0024-offset-origins.md.
class OffsetOrigins {
 public:
  /// Needs   `walls` to outlive it.
  /// Cost    a look at each pair of walls whose boxes overlap, some 300 bytes a wall. Where
  ///         these are more than 2^25, or more come near than 2^16 and 16 a wall, nothing is certain,
  ///         nor on a curve near more than 16 walls.
  explicit OffsetOrigins(const Surfaces& walls);

  /// Where a ray meets a wall.
  struct WallPoint {
    Vec2 point, normal;  ///< of length 1: to the left of a segment, outward of a curve
  };
  /// Needs   a direction of length 1, but for 2^-10 of it, and the ray's exact hit.
  /// Gives   nullopt where another wall or the end of an arc is too near, the ray grazes, or starts too
  ///         far away.
  std::optional<WallPoint> meet(const Ray& ray, const NearestHit& hit) const;
  /// How far an origin is from its wall, along the normal.
  double distance() const { return distance_; }

  /// A direction surely leads to one side of a wall where the cosine of its angle with the normal
  /// is further from 0 than this.
  static constexpr double kLeastCosine = 0x1p-18;

 private:
  struct Wall {
    Vec2 at, normal;    // an end a; a centre; of a Bezier curve the chord's direction
    double length = 0;  // of an arc the least distance from its centre
    std::uint32_t begin = 0, end = 0;  // in stretches_ of a segment, in near_ of a curve
    bool ready = false;                // its points have origins beside them
    bool is_plain = false;             // no arc, or one whose ends lie on it
  };
  Wall wall(const Segment& ends) const;
  Wall wall(const Arc& arc) const;
  Wall wall(const Bezier& curve) const;
  void find_neighbours();
  void keep_neighbours(const Segment&, Wall& wall, std::span<const std::uint32_t> others);
  template <class Curve>
  void keep_neighbours(const Curve&, Wall& wall, std::span<const std::uint32_t> others);
  // Of `other`, which is plain: where it comes near, from end a of the wall on.
  void add_near(const Wall& wall, const Segment& other, const Wall& second,
                std::vector<Range>& found) const;
  void add_near(const Wall& wall, const Arc& other, const Wall& second,
                std::vector<Range>& found) const;
  void add_near(const Wall& wall, const Bezier& other, const Wall& second,
                std::vector<Range>& found) const;
  bool is_clear(const Segment&, const Wall& wall, const WallPoint& met) const;
  bool is_clear(const Arc& arc, const Wall& wall, WallPoint& met) const;
  bool is_clear(const Bezier& curve, const Wall& wall, WallPoint& met) const;
  bool others_far(const Wall& wall, const Vec2& point) const;
  bool is_far(const Segment&, const Wall& wall, const Vec2& point) const;
  bool is_far(const Arc& arc, const Wall& wall, const Vec2& point) const;
  bool is_far(const Bezier& curve, const Wall& wall, const Vec2& point) const;
  bool are_far(std::uint32_t a, std::uint32_t b, const Bounds& box) const;
  bool are_far(const Segment&, const Wall& wall, std::span<const Vec2> points) const;
  bool are_far(const Arc& arc, const Wall& wall, std::span<const Vec2> points) const;
  bool are_far(const Bezier&, const Wall&, std::span<const Vec2>) const { return false; }
  bool ends_far(const Vec2& one, const Vec2& other, const Vec2& point) const;

  const Surfaces& walls_;
  double apart_ = 0, distance_ = 0, farthest_ = 0;
  std::vector<Wall> table_;
  std::vector<Range> stretches_;     // of each segment apart, ascending
  std::vector<std::uint32_t> near_;  // of each curve
};

}  // namespace flatray
