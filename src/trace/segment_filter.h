#pragma once
#include "geom/decide.h"
#include "geom/ray.h"

namespace flatray {

/// What doubles with bounds can say of a ray and a wall.
struct FilteredHit {
  enum class Verdict : std::uint8_t {
    missed,  ///< surely not met at t >= 0
    sure,    ///< surely met at t > 0, between its ends, there for the first time
    open
  } verdict;
  double low, high;        ///< t is surely between, where the wall is met at all
  Root root = Root::none;  ///< of a curve, where sure
};

/// What is sure of a ray and a segment without exact arithmetic: by the sides of its ends a, b, and
/// t = (a x b) / (d x b - d x a) as the ray's origin sees them. An infinity or NaN makes every
/// comparison that would be "sure" false.
///
/// Cost    15 ns.
class SegmentFilter {
 public:
  explicit SegmentFilter(const Ray& ray)
      : origin_(pair_of(kCounted, ray.origin)), direction_(pair_of(kCounted, ray.direction)) {}

  FilteredHit operator()(const Segment& segment) const {
    using enum FilteredHit::Verdict;
    const auto a = pair_of(kCounted, segment.a) - origin_;
    const auto b = pair_of(kCounted, segment.b) - origin_;
    const auto side_a = cross(direction_, a), side_b = cross(direction_, b);
    const Sign at_a = side_a.sure_sign(), at_b = side_b.sure_sign();
    if (at_a == at_b && at_a != Sign::zero) return {missed, 0, 0};
    const Near t = Near(cross(a, b)) / Near(side_b - side_a);
    if (t.high() < 0) return {missed, 0, 0};
    if (!(t.low() > 0)) return {open, -kInfinity, kInfinity};
    const bool between = at_a == -at_b && at_a != Sign::zero;
    return {between ? sure : open, t.low(), t.high()};
  }

 private:
  Pair<Term<0>> origin_, direction_;
};

}  // namespace flatray
