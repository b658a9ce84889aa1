// needs: mpfr
#include "precise/flight.h"

#include <gtest/gtest.h>

#include "geom/enclosure.h"
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

}  // namespace
}  // namespace flatray
