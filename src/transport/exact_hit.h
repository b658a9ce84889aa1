#pragma once
#include "geom/bounded.h"
#include "geom/hit_time.h"
#include "trace/hits.h"

namespace flatray {

/// The point at which a ray arrives at a wall, without rounding: origin + t * direction for the
/// exact t.
///
/// Cost    bounded double-doubles, well under 1 us; the rationals, some 20 us, where those leave a
///         doubt.
class ExactHit {
 public:
  /// Needs   a ray that crosses the wall: not along a segment, nor tangent to a circle.
  ExactHit(const Ray& ray, const Segment& wall);
  ExactHit(const Ray& ray, const Circle& wall, Root root);

  /// Nearest double of each coordinate.
  Vec2 nearest() const { return rounded(centre_); }
  /// The point as seen from the centre of its circle, nearest doubles. Needs a hit of a circle.
  Vec2 from_centre() const { return rounded(Vec2(0, 0)); }

  /// Side of the line through a segment, positive to the left of a -> b. Exact.
  Sign side_of(const Segment& segment) const;
  /// Positive outside the circle, zero on it. Exact.
  Sign side_of(const Circle& circle) const;
  /// Whether the point lies on the closed segment. Exact.
  bool on(const Segment& segment) const;

 private:
  struct LinearForm;
  Sign sign(const LinearForm& form) const;
  Vec2 rounded(const Vec2& centre) const;
  double exactly_rounded(const Vec2& centre, int axis) const;

  Ray ray_;
  HitTime time_;
  Vec2 centre_{0, 0};  // of the circle; 0 for a segment
  double radius_ = 0;
  int root_ = 0;           // -1 first, 1 second; 0 for a segment
  Bounded x_ = 0, y_ = 0;  // from the centre
};

}  // namespace flatray
