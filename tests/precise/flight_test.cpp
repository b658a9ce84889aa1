// needs: mpfr
#include "precise/flight.h"

#include <gtest/gtest.h>

#include "geom/enclosure.h"
#include "oracle/families.h"
#include "precise/certain.h"
#include "precise/rooms.h"

namespace flatray {
namespace {

constexpr int kFew = 60, kMany = 2000;

Ball in_balls(const Ball& x) { return x; }
Ball in_balls(const Bounded& x) {
  const Ball middle = Ball(x.hi(), kMany) + Ball(x.lo(), kMany);
  const Ball unit = either_root(Ball(1, kMany));  // from -1 to 1
  return middle + Ball(x.error(), kMany) * unit;
}

template <class Number>
void expect_holds(const Number& x, const Certain& truth) {
  const auto off = (in_balls(x) - truth.ball()).sign();
  EXPECT_TRUE(!off || *off == Sign::zero);
}

template <class Flight, class Truth>
void expect_holds_all(const Flight& few, const Truth& truth) {
  expect_holds(few.direction().x, truth.direction().x);
  expect_holds(few.direction().y, truth.direction().y);
  expect_holds(few.moment(), truth.moment());
  expect_holds(few.point().x, truth.point().x);
  expect_holds(few.point().y, truth.point().y);
}

// A flight in few bits, led along the walls of one in many: as far as it can tell its own points, all
// that it holds true is.
template <class Number, class Make>
std::size_t held_true(const Surfaces& walls, const Ray& start, const Make& make) {
  const PeriodicWalls periodic(walls, {});
  const auto certain = [](double x) { return Certain(x, kMany); };
  Flight<Certain, decltype(certain)> truth(walls, periodic, start, certain);
  Flight<Number, Make> few(walls, periodic, start, make);
  for (std::size_t bounces = 0; bounces < 40; ++bounces) {
    const Prospect next = truth.next(), seen = few.next();
    EXPECT_EQ(next.kind, Prospect::Kind::wall);
    if (seen.kind == Prospect::Kind::open) return bounces;
    EXPECT_EQ(seen.walls, next.walls);
    truth.blur();
    if (!truth.bounce(next.walls.front()) || !few.bounce(next.walls.front())) return bounces;
    expect_holds_all(few, truth);
  }
  return 40;
}

void expect_held_true(const Surfaces& walls, const Ray& start, std::size_t least) {
  const auto ball = [](double x) { return Ball(x, kFew); };
  const auto bounded = [](double x) { return Bounded(x); };
  EXPECT_GE(held_true<Ball>(walls, start, ball), least);
  EXPECT_GE(held_true<Bounded>(walls, start, bounded), least);
}

TEST(Flight, HoldsWhatIsTrueBetweenStraightWalls) {
  const Surfaces walls = room({{0, 0}, {7, -1}, {9, 5}, {4, 9}, {-1, 6}});
  for (int i = 0; i < 10; ++i) expect_held_true(walls, {{4, 3}, {3, 1.7 + 0.01 * i}}, 30);
}

TEST(Flight, HoldsWhatIsTrueInCirclesAndEllipses) {
  Surfaces circle, ellipse;
  circle.add(Circle{{0.3, 0.1}, 1});
  ellipse.add(Arc{Ellipse({0.1, 0}, {3, 1}, {-0.5, 2}), Arc::Extent::whole, {0, 0}, {0, 0}});
  for (int i = 0; i < 10; ++i) {
    expect_held_true(circle, {{0.5, 0.25}, {-1, 2 + 0.1 * i}}, 30);
    expect_held_true(ellipse, {{1, 0.5}, {1, 0.3 + 0.1 * i}}, 5);
  }
}

TEST(Flight, HoldsWhatIsTrueAmongDiscs) {
  Surfaces walls = room({{-2, -2}, {2, -2}, {2, 2}, {-2, 2}});
  walls.add(Circle{{0, 0}, 1});
  for (int i = 0; i < 10; ++i) expect_held_true(walls, {{-1.5, 0.3 + 0.01 * i}, {1, 0.21}}, 5);
}

// Rays that graze the box about a wall, or start beside it, at any scale.
template <class Wall>
void expect_missed_where_passed(const Wall& wall, double scale) {
  const auto certain = [](double x) { return Certain(x, kFew); };
  const Bounds box = bounds_of(wall);
  int passed = 0, met = 0;
  for (int i = 0; i < 300; ++i) {
    oracle::Draw draw(11, 0, static_cast<std::uint64_t>(i));
    const Vec2 corner = draw.any(box.corners()), off = draw.signed_halves(60) * box.size();
    const Vec2 target = i % 3 == 0 ? corner : Vec2(corner + off);
    const Vec2 start = scale * (20 * draw.point() - Vec2(10, 10));
    const Ray ray{start, draw.unit() < 0.2 ? Vec2(start - target) : Vec2(target - start)};
    const Course<Certain, decltype(certain)> course(ray, certain);
    bool is_met = false;
    for (const auto& meeting : course.meet(wall, false)) is_met |= meeting.met != Met::no;
    const bool is_passed = course.plain().passes(within(box));
    EXPECT_FALSE(is_passed && is_met) << i;
    passed += is_passed;
    met += is_met;
  }
  EXPECT_GE(passed, 50);
  EXPECT_GE(met, 10);
}

// Where a curve reaches beyond the doubles its box ends at the largest, and proves nothing.
TEST(Flight, ACurveThatReachesBeyondTheDoublesIsNotPassedByItsBox) {
  const Ray start{{1.79e308, -1.7e308}, {0.5, 1}};
  for (const Ellipse& curve :
       {Ellipse(Circle{{1.7e308, 0}, 1e308}), Ellipse({1.7e308, 0}, {1e308, 0}, {0, 0.9e308})}) {
    Surfaces walls;
    walls.add(Arc{curve, Arc::Extent::whole, {0, 0}, {0, 0}});
    const PeriodicWalls periodic(walls, {});
    const auto certain = [](double x) { return Certain(x, kMany); };
    EXPECT_NE((Flight<Certain, decltype(certain)>(walls, periodic, start, certain).next().kind),
              Prospect::Kind::escape);
  }
}

TEST(Course, WhatPassesTheBoxOfAWallDoesNotMeetIt) {
  for (const double scale : {1.0, 0x1p-300, 0x1p300}) {
    const auto at = [&](double x, double y) { return Vec2(scale * x, scale * y); };
    expect_missed_where_passed(Segment{at(1, 2), at(3, -0.7)}, scale);
    expect_missed_where_passed(Segment{at(1, 2), at(1, 3)}, scale);
    const Ellipse curve(at(0.1, 0), at(3, 1), at(-0.5, 2));
    expect_missed_where_passed(Arc{curve, Arc::Extent::whole, {0, 0}, {0, 0}}, scale);
    expect_missed_where_passed(Arc{curve, Arc::Extent::between, at(6, 2), at(-1, 4)}, scale);
    expect_missed_where_passed(Bezier(at(0, 0), at(2, 3), at(4, -1), at(5, 1)), scale);
  }
}

}  // namespace
}  // namespace flatray
