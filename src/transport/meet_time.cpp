#include "transport/meet_time.h"

#include "geom/decide.h"

namespace flatray {
namespace {

// t = numer / denom.
template <class Number>
struct Quotient {
  Number numer, denom;
};

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

// t = (b +- sqrt(q)) / a.
template <class Number>
struct RootTime {
  Number a, b, q;
  Number outside;  // the product of the roots, times a
};
template <class Make>
auto circle_time(const Make& number, const Mover& mover, const Leg& leg, const Circle& wall) {
  const auto seen = relative(number, mover, leg, wall.centre);
  const auto r2 = number(wall.radius) * number(wall.radius), a = dot(seen.velocity, seen.velocity),
             k = cross(seen.at, seen.velocity);
  return RootTime<decltype(number(0.0))>{a, -dot(seen.at, seen.velocity), r2 * a - k * k,
                                         dot(seen.at, seen.at) - r2};
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

void MeetTime::approximate() {
  if (kind_ == Kind::circle) {
    const auto time = circle_time(kBounded, *mover_, *leg_, circle_);
    const Bounded root = root_ > 0 ? square_root(time.q) : -square_root(time.q);
    // b and the root may cancel: then the other root and the product of both.
    const bool alike = (time.b.hi() > 0) == (root_ > 0);
    value_ = alike ? (time.b + root) / time.a : time.outside / (time.b - root);
    return;
  }
  const auto time = kind_ == Kind::clock  ? clock_time(kBounded, *mover_, time_)
                    : kind_ == Kind::line ? line_time(kBounded, *mover_, *leg_, line_)
                                          : end_time(kBounded, *mover_, *leg_, line_,
                                                     kind_ == Kind::end_a ? line_.a : line_.b);
  value_ = time.numer / time.denom;
}

HitTime::Exact MeetTime::exact() const {
  if (kind_ == Kind::circle) {
    auto time = circle_time(kRational, *mover_, *leg_, circle_);
    return {std::move(time.b), root_, std::move(time.q), std::move(time.a)};
  }
  auto time = kind_ == Kind::clock  ? clock_time(kRational, *mover_, time_)
              : kind_ == Kind::line ? line_time(kRational, *mover_, *leg_, line_)
                                    : end_time(kRational, *mover_, *leg_, line_,
                                               kind_ == Kind::end_a ? line_.a : line_.b);
  if (time.denom.sign() == Sign::negative) return {-time.numer, 0, 0, -time.denom};
  return {std::move(time.numer), 0, 0, std::move(time.denom)};
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
