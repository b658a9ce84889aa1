#pragma once
#include "geom/hit_time.h"
#include "trace/hits.h"

namespace flatray {

/// The point at which a ray arrives at a wall, without rounding: origin + t * direction for the
/// exact t.
class ExactHit {
 public:
  /// Needs   `hit` to be of that wall; a ray that crosses a segment, not one that runs along it.
  ExactHit(const Ray& ray, const Segment& wall);
  ExactHit(const Ray& ray, const Circle& wall, Root root);

  /// Nearest double of each coordinate.
  Vec2 nearest() const;
  /// Unit-free direction from the centre of the circle it lies on to the point, each component
  /// rounded once.
  Vec2 from_centre() const;

  /// Side of the line through a segment, positive to the left of a -> b. Exact, by rationals: some
  /// 20 us.
  Sign side_of(const Segment& segment) const;
  /// Positive outside the circle, zero on it. Exact, as above.
  Sign side_of(const Circle& circle) const;
  /// Whether the point lies on the closed segment. Exact, as above.
  bool on(const Segment& segment) const;

 private:
  struct LinearForm;
  Sign sign(const LinearForm& form) const;

  Ray ray_;
  bool on_circle_;
  Segment segment_{};
  Circle circle_{};
  int root_ = 0;  // -1 first, 1 second, 0 on a segment
  HitTime time_;
};

}  // namespace flatray
