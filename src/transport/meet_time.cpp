#include "transport/meet_time.h"

#include "geom/decide.h"

namespace flatray {
namespace {

template <class Make>
auto edge_of(const Make& number, const Segment& wall) {
  return pair_of(number, wall.b) - pair_of(number, wall.a);
}

template <class Make>
auto chord_of(const Make& number, const Mover& mover, const Leg& leg, const Circle& wall) {
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

PlaceOn crossing_place(const Mover& mover, const Leg& leg, const Segment& wall) {
  // a + s (b - a) with s = (at x velocity) / (edge x velocity)
  const Sign turn = heading(mover, leg, wall);
  const auto along = [&](const Vec2& end) {
    return turn * decide([&](const auto& number) {
             const auto seen = relative(number, mover, leg, end);
             return cross(seen.at, seen.velocity);
           });
  };
  const Sign from_a = along(wall.a);
  if (from_a == Sign::negative) return PlaceOn::outside;
  const Sign from_b = along(wall.b);
  if (from_b == Sign::positive) return PlaceOn::outside;
  return from_a == Sign::zero || from_b == Sign::zero ? PlaceOn::at_end : PlaceOn::inner;
}

bool crosses(const Mover& mover, const Leg& leg, const Circle& wall) {
  return decide([&](const auto& number) { return chord_of(number, mover, leg, wall).q; }) ==
         Sign::positive;
}

MeetTime MeetTime::at(const Mover& mover, double time) { return {mover, nullptr, time, {}}; }

MeetTime MeetTime::on_line(const Mover& mover, const Leg& leg, const Segment& wall) {
  return {mover, &leg, 0, {wall.a, wall.a, wall.b}};
}

MeetTime MeetTime::at_end(const Mover& mover, const Leg& leg, const Segment& wall, bool at_b) {
  const auto across = [](const Vec2& v) { return Vec2(-v.y(), v.x()); };
  return {mover, &leg, 0, {at_b ? wall.b : wall.a, across(wall.a), across(wall.b)}};
}

MeetTime MeetTime::on_circle(const Mover& mover, const Leg& leg, const Circle& wall, Root root) {
  return {mover, &leg, 0, {wall.centre, {0, 0}, {0, 0}, wall.radius, root_sign(root)}};
}

template <class Make>
auto MeetTime::line_time(const Make& number) const {
  using Time = Quotient<decltype(number(0.0))>;
  if (leg_ == nullptr)
    return Time{number(time_) - number(mover_->since.hi) - number(mover_->since.lo), number(1.0)};
  const auto seen = relative(number, *mover_, *leg_, met_.p);
  const auto way = edge_of(number, {met_.from, met_.to});
  return Time{cross(seen.at, way), cross(way, seen.velocity)};
}

template <class Make>
auto MeetTime::circle_time(const Make& number) const {
  return chord_of(number, *mover_, *leg_, {met_.p, met_.radius});
}

MeetTime::MeetTime(const Mover& mover, const Leg* leg, double time, const Met& met)
    : mover_(&mover), leg_(leg), time_(time), met_(met) {
  if (met.root != 0) {
    value_ = circle_time(kBounded).root(met.root);
  } else {
    const auto quotient = line_time(kBounded);
    value_ = quotient.numer / quotient.denom;
  }
}

Quadratic MeetTime::exact() const {
  if (met_.root != 0) return root_of(circle_time(kRational), met_.root);
  const auto time = line_time(kRational);
  return time.numer / time.denom;
}

std::strong_ordering compare(const MeetTime& a, const MeetTime& b) {
  if (const auto sign = (a.value_ - b.value_).sign()) return order(*sign);
  return compare(a.exact(), b.exact());
}

Sign MeetTime::sign() const {
  if (const auto sign = value_.sign()) return *sign;
  return exact().sign();
}

}  // namespace flatray
