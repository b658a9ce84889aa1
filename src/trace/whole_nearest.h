#pragma once
#include "trace/hits.h"
#include "trace/kernels/whole.h"
#include "trace/rays.h"

namespace flatray {

/// Straight walls on whole numbers of one unit, and the rays that are whole with them: doubles then
/// hold every side and both terms of every t (trace/kernels/whole.h).
class WholeWalls {
 public:
  /// Asks every wall, up to the first that is not whole. Cost   some ns a wall.
  explicit WholeWalls(const Surfaces& walls);
  /// Whether rays may be whole with the walls: all are straight, in as few digits.
  bool any() const { return any_; }
  /// The largest power of two that all ends are multiples of. Needs any().
  double unit() const { return unit_; }
  /// Where origins of whole rays lie. Needs any().
  const lanes::WholeBox& box() const { return box_; }
  /// Whether a ray is whole. One without direction never is.
  bool hold(const Ray& ray) const;

 private:
  bool any_ = false;
  double unit_ = kInfinity;
  lanes::WholeBox box_{};
};

/// The nearest of the walls offered to a ray that WholeWalls hold: the answer of ExactNearest, by
/// doubles in which nothing is rounded but t, once.
///
/// Cost    5 to 10 ns a wall.
class WholeNearest {
 public:
  /// Needs   `walls` to outlive it.
  WholeNearest(const Surfaces& walls, const Ray& ray) : walls_(walls), ray_(ray) {}

  void offer(std::uint32_t slot);
  /// Whether nothing met later than t can be the nearest.
  bool settled(double t) const { return best_.t < t; }
  const NearestHit& hit() const { return best_; }

 private:
  struct Time {
    double numer, denom;  // t = numer / denom; denom > 0
  };
  void offer_along(std::uint32_t number, const Vec2& a, const Vec2& b);
  void offer(NearestHit hit, const Time& time);

  const Surfaces& walls_;
  const Ray ray_;
  NearestHit best_;
  Time time_{0, 1};
};

}  // namespace flatray
