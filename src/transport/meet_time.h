#pragma once
#include <algorithm>
#include <compare>
#include <limits>

#include "anim/moving_walls.h"
#include "geom/decide.h"
#include "geom/hit_time.h"
#include "geom/pair.h"
#include "geom/primitives/arc.h"

namespace flatray {

/// A point in even motion from a time on: at + (time - since) * velocity.
struct Mover {
  Vec2 at, velocity;
  DoubleDouble since{0, 0};  ///< seconds
};

/// The velocity of a wall in the arithmetic of `number`.
template <class Make>
auto velocity_of(const Make& number, const Leg& leg) {
  if (leg.is_last()) return pair_of(number, leg.velocity);
  const auto way = pair_of(number, leg.to) - pair_of(number, leg.from);
  const auto time = number(leg.end) - number(leg.begin);
  return Pair<decltype(number(0.0))>{way.x / time, way.y / time};
}

/// A mover as seen from a point of a wall that moves, which then stands still: what the paper calls
/// the frame trick. Nothing is rounded but by `number`.
template <class Number>
struct Relative {
  Pair<Number> at, velocity;  ///< at Mover::since
};
template <class Make>
auto relative(const Make& number, const Mover& mover, const Leg& leg, const Vec2& point) {
  const auto u = velocity_of(number, leg);
  const auto elapsed = number(mover.since.hi) + number(mover.since.lo) - number(leg.begin);
  const auto at = pair_of(number, mover.at) - pair_of(number, leg.from) - pair_of(number, point);
  return Relative<decltype(number(0.0))>{at - elapsed * u, pair_of(number, mover.velocity) - u};
}

/// On which side of the line through a segment a mover is at Mover::since, positive to the left.
Sign side_of(const Mover& mover, const Leg& leg, const Segment& wall);
/// Positive outside a circle, zero on it.
Sign side_of(const Mover& mover, const Leg& leg, const Circle& wall);

/// The side of the line through a segment to which it moves; zero along it.
Sign heading(const Mover& mover, const Leg& leg, const Segment& wall);
/// Positive where it gets farther from the centre, negative where nearer.
Sign heading(const Mover& mover, const Leg& leg, const Circle& wall);

/// Where a mover crosses the line through a segment. Needs   a heading.
PlaceOn crossing_place(const Mover& mover, const Leg& leg, const Segment& wall);

/// Whether the line of a mover crosses a circle, in two points.
bool crosses(const Mover& mover, const Leg& leg, const Circle& wall);

/// When a mover meets something, counted from Mover::since, kept as the geometry that defines it.
///
/// Needs   what it is made of to outlive it.
/// Gives   comparisons without error, and what follows from it rounded once, at every scale.
/// Cost    bounded double-doubles; rationals only where those leave a doubt.
/// Source  HitTime, in relative motion.
class MeetTime {
 public:
  /// A time of the clock.
  static MeetTime at(const Mover& mover, double time);
  /// The line through a segment. Needs   a heading.
  static MeetTime on_line(const Mover& mover, const Leg& leg, const Segment& wall);
  /// The line across a segment through one of its ends. Needs   a mover that moves along it.
  static MeetTime at_end(const Mover& mover, const Leg& leg, const Segment& wall, bool at_b);
  /// Needs   crosses().
  static MeetTime on_circle(const Mover& mover, const Leg& leg, const Circle& wall, Root root);

  friend std::strong_ordering compare(const MeetTime& a, const MeetTime& b);
  Sign sign() const;

  /// Nearest double to formula(number, t), as round_once() has it. Needs   a formula that divides by
  /// nothing that t is part of.
  ///
  ///   time.round([&](const auto& number, const auto& t) { return number(x) + t * number(v); })
  template <class Formula>
  double round(const Formula& formula) const {
    if (const auto near = formula(kBounded, value_).nearest()) return *near;
    return clamped(formula(kQuadratic, exact()).nearest());
  }
  /// The same as a sum of two doubles. Error   kSumError of it.
  template <class Formula>
  DoubleDouble sum(const Formula& formula) const {
    const Bounded near = formula(kBounded, value_);
    if (near.error() <= kSumError * std::fabs(near.hi())) return {near.hi(), near.lo()};
    const Quadratic sum = formula(kQuadratic, exact());
    const double hi = clamped(sum.nearest());
    return {hi, clamped((sum - hi).nearest())};
  }
  static constexpr double kSumError = 0x1p-80;

 private:
  static double clamped(double x) {
    constexpr double largest = std::numeric_limits<double>::max();
    return std::clamp(x, -largest, largest) + 0.0;  // never -0
  }
  // A line through p along to - from, or a circle about p.
  struct Met {
    Vec2 p{0, 0}, from{0, 0}, to{0, 0};
    double radius = 0;
    int root = 0;  // 0 for a line
  };
  MeetTime(const Mover& mover, const Leg* leg, double time, const Met& met);
  template <class Make>
  auto line_time(const Make& number) const;
  template <class Make>
  auto circle_time(const Make& number) const;
  Quadratic exact() const;

  const Mover* mover_;
  const Leg* leg_;  // nullptr of a time of the clock
  double time_;
  Met met_;
  Bounded value_{0.0};
};

}  // namespace flatray
