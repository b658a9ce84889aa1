// Particles among moving mirrors where doubles are huge, tiny, or cancel.
#include <gtest/gtest.h>

#include <limits>

#include "moving_rooms.h"
#include "oracle/families.h"

namespace flatray {
namespace {

using oracle::Draw;

constexpr double kScaledUlp = 0x1p-52;

const std::vector<Vec2> kScaledPentagon = {{0, 0}, {5, -1}, {7, 3}, {3, 6}, {-1, 3}};

// scenes/chamber/fermi.toml: meeting n with the piston is at x = 41 / (2 n + 3). A place on the wall
// that comes out as 1e-33, not 0, is within no ulps of the wall: the orbit ended after 96 bounces as
// in a corner.
TEST(MovingOrbit, GoesOnWherePlacesCancelToNothing) {
  MovingRoom room;
  room.add_ring({{0, 0}, {10, 0}, {10, 4}, {0, 4}});
  room.add(Segment{{0, 4.2}, {0, -0.2}}, {{0, kInfinity, {10, 0}, {0, 0}, {-1, 0}}});
  const MovingOrbit found = trace_moving_orbit(room, {{1, 1}, {4, 3}}, 0, {2000});
  ASSERT_EQ(found.orbit.end, OrbitEnd::limit);
  double meetings = 0;
  for (const Bounce& bounce : found.orbit.bounces) {
    if (bounce.surface == 3) {
      EXPECT_EQ(bounce.point.x(), 0);
    }
    if (bounce.surface != 4) continue;
    ++meetings;
    const double x = 41 / (2 * meetings + 3);
    EXPECT_NEAR(bounce.point.x(), x, 1e-13) << meetings;
  }
  EXPECT_GT(meetings, 900);
}

// Lengths times `size`, times times `time`, powers of two.
MovingRoom scaled(const MovingRoom& room, double size, double time) {
  MovingRoom made;
  for (std::uint32_t i = 0; i < room.world.surfaces.size(); ++i) {
    std::vector<Leg> legs = room.legs(i);
    for (Leg& leg : legs)
      leg = {leg.begin * time, leg.end * time, leg.from * size, leg.to * size,
             leg.velocity * size / time};
    const Surfaces& all = room.world.surfaces;
    if (all.segment_slot(i) != kNoSurface)
      made.add(Segment{all.segment(i).a * size, all.segment(i).b * size}, legs);
    else
      made.add(Circle{all.arc(i).curve.centre * size, all.arc(i).curve.u.x() * size}, legs);
  }
  return made;
}

MovingRoom mixed_room() {
  MovingRoom room;
  room.add_ring(kScaledPentagon);
  room.add(Circle{{3, 2}, 0.75}, {0.0625, -0.03125});
  room.add(Circle{{0.5, 2.25}, 0.25});
  room.add(Segment{{0, -0.5}, {0, 0.5}}, zigzag(4.5, 6, 0.75, 40));
  return room;
}

TEST(MovingOrbit, IsTheSameAtEveryScaleThatDoublesHave) {
  const MovingRoom room = mixed_room();
  const MovingLimits limits{40};
  const MovingOrbit one = trace_moving_orbit(room, {{1, 1}, {3, 4}}, 0.125, limits);
  ASSERT_EQ(one.orbit.bounces.size(), 40U);
  for (const int size : {-900, -600, -400, -262, -40, 40, 256, 300, 400, 600, 900})
    for (const int time : {-300, -1, 0, 1, 300}) {
      if (std::abs(size - time) > 980) continue;
      const double s = std::ldexp(1, size), t = std::ldexp(1, time);
      const MovingOrbit other = trace_moving_orbit(
          scaled(room, s, t), {Vec2(1, 1) * s, Vec2(3, 4) * s / t}, 0.125 * t, limits);
      ASSERT_EQ(other.orbit.bounces.size(), 40U) << size << ' ' << time;
      for (std::size_t i = 0; i < 40; ++i) {
        const Bounce &a = one.orbit.bounces[i], &b = other.orbit.bounces[i];
        ASSERT_EQ(a.surface, b.surface) << size << ' ' << time << ' ' << i;
        EXPECT_EQ(Vec2(a.point * s), b.point) << size << ' ' << time << ' ' << i;
        EXPECT_EQ(Vec2(a.out * s / t), b.out) << size << ' ' << time << ' ' << i;
        EXPECT_EQ(a.normal, b.normal) << size << ' ' << time << ' ' << i;
        EXPECT_EQ(a.t * t, b.t) << size << ' ' << time << ' ' << i;
        EXPECT_EQ(one.times[i].time * t, other.times[i].time) << size << ' ' << time << ' ' << i;
      }
    }
}

// A disc of radius s at (5 s, s / 2), met at x = (5 - sqrt(3) / 2) s.
TEST(MovingOrbit, AHugeDiscAtRestIsMetWhereItIs) {
  const double s = 0x1p400;
  MovingRoom room;
  room.add(Circle{{5 * s, s / 2}, s});
  const MovingOrbit found = trace_moving_orbit(room, {{0, 0}, {4 * s, 0}}, 0, {1});
  ASSERT_EQ(found.orbit.bounces.size(), 1U);
  EXPECT_EQ(found.times[0].time, 1.0334936490538904);  // (5 - sqrt(3) / 2) / 4
  EXPECT_NEAR(found.orbit.bounces[0].point.x() / s, 4 * 1.0334936490538904, 8 * kScaledUlp);
  EXPECT_EQ(found.orbit.bounces[0].point.y(), 0);
}

TEST(MovingOrbit, WhatIsMetAfterTheLastDoubleOfTimeIsNotMet) {
  MovingRoom room;
  room.add(Circle{{0x1p900, 0}, 1});
  const MovingOrbit found = trace_moving_orbit(room, {{0, 0}, {0x1p-900, 0}}, 0, {5});
  EXPECT_EQ(found.orbit.end, OrbitEnd::limit);
  EXPECT_TRUE(found.orbit.bounces.empty());
  constexpr double last = std::numeric_limits<double>::max();
  EXPECT_EQ(found.end_time, last);
  EXPECT_EQ(found.orbit.end_point, Vec2(last * 0x1p-900, 0));
}

// The room is some hundred of the smallest doubles wide.
TEST(MovingOrbit, NothingTunnelsAmongTheSmallestDoubles) {
  const double s = 0x1p-1068;
  const MovingRoom room = scaled(mixed_room(), s, 1);
  for (std::uint64_t item = 0; item < 20; ++item) {
    Draw draw(14, 1, item);
    const double vx = 8 * draw.unit() - 4, vy = 8 * draw.unit() - 4;
    const MovingOrbit found =
        trace_moving_orbit(room, {Vec2(1, 1) * s, Vec2(vx, vy) * s}, 0, {100});
    EXPECT_NE(found.orbit.end, OrbitEnd::escape) << item;
    for (const Bounce& bounce : found.orbit.bounces)
      for (std::size_t i = 0; i < kScaledPentagon.size(); ++i)
        EXPECT_GE(cross(kScaledPentagon[(i + 1) % kScaledPentagon.size()] - kScaledPentagon[i],
                        bounce.point / s - kScaledPentagon[i]),
                  0)
            << item << ' ' << i;
  }
}

}  // namespace
}  // namespace flatray
