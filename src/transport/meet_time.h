#pragma once
#include <compare>

#include "anim/moving_walls.h"
#include "geom/decide.h"
#include "geom/hit_time.h"
#include "geom/pair.h"

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

/// Where a mover crosses the line through a segment, as a part of the way from its first end to the
/// other. Needs   a heading.
enum class CrossingPlace { before, at_a, inner, at_b, beyond };
CrossingPlace crossing_place(const Mover& mover, const Leg& leg, const Segment& wall);

/// Whether the line of a mover crosses a circle, in two points.
bool crosses(const Mover& mover, const Leg& leg, const Circle& wall);

/// When a mover meets something, counted from Mover::since, kept as the geometry that defines it.
///
/// Needs   what it is made of to outlive it.
/// Gives   comparisons without error. Source   HitTime, in relative motion.
class MeetTime {
 public:
  /// A time of the clock.
  static MeetTime at(const Mover& mover, double time);
  /// The line through a segment. Needs   a heading.
  static MeetTime on_line(const Mover& mover, const Leg& leg, const Segment& wall);
  /// The line across a segment through one of its ends. Needs   a mover that moves along it.
  static MeetTime at_end(const Mover& mover, const Leg& leg, const Segment& wall, bool at_b);
  /// Needs   crosses().
  static MeetTime on_circle(const Mover& mover, const Leg& leg, const Circle& wall,
                            HitTime::Root root);

  const Bounded& value() const { return value_; }
  friend std::strong_ordering compare(const MeetTime& a, const MeetTime& b);
  Sign sign() const;

 private:
  enum class Kind { clock, line, end_a, end_b, circle };
  MeetTime(Kind kind, const Mover& mover, const Leg* leg);
  void approximate();
  HitTime::Exact exact() const;

  Kind kind_;
  const Mover* mover_;
  const Leg* leg_;
  double time_ = 0;
  Segment line_{};
  Circle circle_{};
  int root_ = 0;
  Bounded value_{0.0};
};

}  // namespace flatray
