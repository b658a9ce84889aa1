#include "transport/meet_time.h"

#include "geom/decide.h"

namespace flatray {
namespace {

template <class Make>
auto edge_of(const Make& number, const Segment& wall) {
  return pair_of(number, wall.b) - pair_of(number, wall.a);
}

template <class Make>
auto line_time(const Make& number, const Mover& mover, const Leg& leg, const Segment& wall) {
  const auto seen = relative(number, mover, leg, wall.a);
  const auto edge = edge_of(number, wall);
  return Quotient<decltype(number(0.0))>{cross(seen.at, edge), cross(edge, seen.velocity)};
}

template <class Make>
auto end_time(const Make& number, const Mover& mover, const Leg& leg, const Segment& wall,
              const Vec2& end) {
  const auto seen = relative(number, mover, leg, end);
  const auto edge = edge_of(number, wall);
  return Quotient<decltype(number(0.0))>{-dot(seen.at, edge), dot(seen.velocity, edge)};
}

template <class Make>
auto clock_time(const Make& number, const Mover& mover, double time) {
  return Quotient<decltype(number(0.0))>{
      number(time) - number(mover.since.hi) - number(mover.since.lo), number(1.0)};
}

template <class Make>
auto circle_time(const Make& number, const Mover& mover, const Leg& leg, const Circle& wall) {
  const auto seen = relative(number, mover, leg, wall.centre);
  return chord_time(seen.velocity, {-seen.at.x, -seen.at.y}, number(wall.radius));
}

}  // namespace

Sign side_of(const Mover& mover, const Leg& leg, const Segment& wall) {
  return decide([&](const auto& number) {
    return cross(edge_of(number, wall), relative(number, mover, leg, wall.a).at);
  });
}

Sign side_of(const Mover& mover, const Leg& leg, const Circle& wall) {
  return decide([&](const auto& number) {
    const auto at = relative(number, mover, leg, wall.centre).at;
    return dot(at, at) - number(wall.radius) * number(wall.radius);
  });
}

Sign heading(const Mover& mover, const Leg& leg, const Segment& wall) {
  return decide([&](const auto& number) {
    return cross(edge_of(number, wall), pair_of(number, mover.velocity) - velocity_of(number, leg));
  });
}

Sign heading(const Mover& mover, const Leg& leg, const Circle& wall) {
  return decide([&](const auto& number) {
    const auto seen = relative(number, mover, leg, wall.centre);
    return dot(seen.at, seen.velocity);
  });
}

CrossingPlace crossing_place(const Mover& mover, const Leg& leg, const Segment& wall) {
  // a + s (b - a) with s = (at x velocity) / (edge x velocity)
  const Sign turn = heading(mover, leg, wall);
  const auto along = [&](const Vec2& end) {
    return turn * decide([&](const auto& number) {
             const auto seen = relative(number, mover, leg, end);
             return cross(seen.at, seen.velocity);
           });
  };
  const Sign from_a = along(wall.a);
  if (from_a == Sign::negative) return CrossingPlace::before;
  if (from_a == Sign::zero) return CrossingPlace::at_a;
  const Sign from_b = along(wall.b);
  if (from_b == Sign::positive) return CrossingPlace::beyond;
  return from_b == Sign::zero ? CrossingPlace::at_b : CrossingPlace::inner;
}

bool crosses(const Mover& mover, const Leg& leg, const Circle& wall) {
  return decide([&](const auto& number) { return circle_time(number, mover, leg, wall).q; }) ==
         Sign::positive;
}

MeetTime::MeetTime(Kind kind, const Mover& mover, const Leg* leg)
    : kind_(kind), mover_(&mover), leg_(leg) {}

MeetTime MeetTime::at(const Mover& mover, double time) {
  MeetTime made(Kind::clock, mover, nullptr);
  made.time_ = time;
  made.approximate();
  return made;
}

MeetTime MeetTime::on_line(const Mover& mover, const Leg& leg, const Segment& wall) {
  MeetTime made(Kind::line, mover, &leg);
  made.line_ = wall;
  made.approximate();
  return made;
}

MeetTime MeetTime::at_end(const Mover& mover, const Leg& leg, const Segment& wall, bool at_b) {
  MeetTime made(at_b ? Kind::end_b : Kind::end_a, mover, &leg);
  made.line_ = wall;
  made.approximate();
  return made;
}

MeetTime MeetTime::on_circle(const Mover& mover, const Leg& leg, const Circle& wall, Root root) {
  MeetTime made(Kind::circle, mover, &leg);
  made.circle_ = wall;
  made.root_ = root_sign(root);
  made.approximate();
  return made;
}

// But on a circle.
template <class Make>
auto MeetTime::in(const Make& number) const {
  if (kind_ == Kind::clock) return clock_time(number, *mover_, time_);
  if (kind_ == Kind::line) return line_time(number, *mover_, *leg_, line_);
  return end_time(number, *mover_, *leg_, line_, kind_ == Kind::end_a ? line_.a : line_.b);
}

void MeetTime::approximate() {
  if (kind_ == Kind::circle) {
    value_ = circle_time(kBounded, *mover_, *leg_, circle_).root(root_);
    return;
  }
  const auto time = in(kBounded);
  value_ = time.numer / time.denom;
}

HitTime::Exact MeetTime::exact() const {
  if (kind_ == Kind::circle) {
    auto time = circle_time(kRational, *mover_, *leg_, circle_);
    return {std::move(time.b), root_, std::move(time.q), std::move(time.a)};
  }
  return HitTime::exact_of(in(kRational));
}

Quadratic MeetTime::quadratic() const {
  const HitTime::Exact time = exact();
  return {time.p / time.a, Rational(time.s) / time.a, time.q};
}

std::strong_ordering compare(const MeetTime& a, const MeetTime& b) {
  if (const auto sign = (a.value_ - b.value_).sign()) return order(*sign);
  return compare(a.exact(), b.exact());
}

Sign MeetTime::sign() const {
  if (const auto sign = value_.sign()) return *sign;
  return sign_of(compare(exact(), {Rational(0), 0, Rational(0), Rational(1)}));
}

}  // namespace flatray
