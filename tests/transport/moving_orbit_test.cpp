#include "transport/moving_orbit.h"

#include <gtest/gtest.h>

#include "full_counts.h"
#include "geom/exact.h"
#include "moving_rooms.h"
#include "oracle/families.h"

namespace flatray {
namespace {

using oracle::Draw;

constexpr double kUlp = 0x1p-52;

const std::vector<Vec2> kPentagon = {{0, 0}, {5, -1}, {7, 3}, {3, 6}, {-1, 3}};

double speed(const Bounce& bounce) { return bounce.out.norm(); }

// A wall that stands at x = 0 and one that comes from x = 10 at -1: Fermi and Ulam's accelerator
// with walls of constant velocity.
MovingRoom accelerator(double piston) {
  MovingRoom room;
  room.add(Segment{{0, 2}, {0, -2}});
  room.add(Segment{{10, -2}, {10, 2}}, {piston, 0});
  return room;
}

TEST(MovingOrbit, BetweenAWallAtRestAndOneThatComesEachBounceIsFasterByTwiceItsSpeed) {
  const MovingRoom room = accelerator(-1);
  const MovingOrbit found = trace_moving_orbit(room, {{1, 0.5}, {3, 0}}, 0, {20});
  ASSERT_EQ(found.orbit.bounces.size(), 20U);
  ASSERT_EQ(found.orbit.end, OrbitEnd::limit);
  Rational clock(0), x(1), v(3), piston(10);
  for (std::size_t i = 0; i < 20; ++i) {
    const Rational wait = i % 2 == 0 ? (piston - x) / (v + Rational(1)) : x / v;
    clock += wait;
    piston -= wait;
    x = i % 2 == 0 ? piston : Rational(0);
    if (i % 2 == 0) v += Rational(2);
    const Bounce& bounce = found.orbit.bounces[i];
    EXPECT_EQ(speed(bounce), v.nearest()) << i;
    EXPECT_EQ(bounce.surface, i % 2 == 0 ? 1U : 0U);
    EXPECT_EQ(bounce.out.y(), 0);
    EXPECT_NEAR(found.times[i].time, clock.nearest(), 8 * kUlp * clock.nearest()) << i;
    EXPECT_NEAR(bounce.point.x(), x.nearest(), 8 * kUlp * 10) << i;
    EXPECT_EQ(found.times[i].wall_velocity, Vec2(i % 2 == 0 ? -1 : 0, 0));
  }
}

// After a bounce at 1 the bar goes round the particle and comes back from its other side: it falls on the
// particle, which is at (t - 1, t - 1), from y = 10 at t = 6, at -10 a second.
TEST(MovingOrbit, AWallJustLeftIsMetWhenItComesBackFromItsOtherSide) {
  MovingRoom room;
  room.add(Segment{{-1, 0}, {1, 0}}, {{0, 4, {0, 0}, {0, 0}, {0, 0}},
                                      {4, 5, {0, 0}, {0, 10}, {0, 0}},
                                      {5, 6, {0, 10}, {6, 10}, {0, 0}},
                                      {6, 7, {6, 10}, {6, 0}, {0, 0}},
                                      {7, kInfinity, {6, 0}, {0, 0}, {0, 0}}});
  const MovingOrbit found = trace_moving_orbit(room, {{-1, 1}, {1, -1}}, 0, {3, 20});
  ASSERT_GE(found.orbit.bounces.size(), 2U);
  EXPECT_NEAR(found.times[1].time, 71.0 / 11, 1e-14);
  EXPECT_NEAR(found.orbit.bounces[1].point.y(), 60.0 / 11, 1e-14);
}

// It leaves the circle along its tangent, or flies on it with it, and is met from behind.
TEST(MovingOrbit, ACircleThatIsStoodOnAlongItsTangentIsMetWhenItComes) {
  for (const Vec2& with : {Vec2(0, 0), Vec2(0, 0.5)}) {
    MovingRoom room;
    room.add(Circle{{0, 0}, 1}, {{0, 1, {0, 0}, with, {0, 0}},
                                 {1, 2, with, with + Vec2(10, 0), {0, 0}},
                                 {2, kInfinity, with + Vec2(10, 0), {0, 0}, {0, 0}}});
    const Vec2 velocity = with == Vec2(0, 0) ? Vec2(0, 0.1) : with;
    const MovingOrbit found = trace_moving_orbit(room, {{1, 0}, velocity}, 0, {1, 20});
    ASSERT_EQ(found.orbit.bounces.size(), 1U);
    EXPECT_NEAR(found.times[0].time, 1.0005, 6e-4);
    EXPECT_GE(found.times[0].time, 1);
  }
}

TEST(MovingOrbit, WhatFliesWithADiscInsideItMeetsTheWallThere) {
  for (const double x : {1 - 0x1p-53, 1 - 0x1p-50, 1 - 0x1p-45, 1 - 0x1p-40}) {
    MovingRoom room;
    room.add(Circle{{0, 0}, 1}, {1, 0});
    room.add(Segment{{5, -3}, {5, 3}});
    const MovingOrbit found = trace_moving_orbit(room, {{x, 0}, {1, 0}}, 0, {1});
    ASSERT_EQ(found.orbit.bounces.size(), 1U) << x;
    EXPECT_EQ(found.orbit.bounces[0].surface, 1U);
  }
}

TEST(MovingOrbit, AWallThatGoesFasterThanTheParticleIsNeverMet) {
  const MovingOrbit never = trace_moving_orbit(accelerator(4), {{1, 0}, {3, 0}}, 0, {10});
  EXPECT_EQ(never.orbit.end, OrbitEnd::escape);
  EXPECT_TRUE(never.orbit.bounces.empty());
  // Met once at 2, it is left with a speed of 1 in the same direction.
  const MovingOrbit once = trace_moving_orbit(accelerator(2), {{1, 0}, {3, 0}}, 0, {10});
  EXPECT_EQ(once.orbit.end, OrbitEnd::escape);
  ASSERT_EQ(once.orbit.bounces.size(), 1U);
  EXPECT_EQ(once.times[0].time, 9);
  EXPECT_EQ(once.orbit.bounces[0].point, Vec2(28, 0));
  EXPECT_EQ(once.velocity, Vec2(1, 0));
  // At the same speed not either.
  EXPECT_EQ(trace_moving_orbit(accelerator(3), {{1, 0}, {3, 0}}, 0, {10}).orbit.end,
            OrbitEnd::escape);
}

TEST(MovingOrbit, AWallFromBehindMeetsAParticleThatIsSlower) {
  const MovingOrbit found = trace_moving_orbit(accelerator(-8), {{1, 0}, {-0.5, 0}}, 0, {1});
  ASSERT_EQ(found.orbit.bounces.size(), 1U);
  EXPECT_EQ(found.orbit.bounces[0].surface, 1U);
  EXPECT_EQ(found.times[0].time, 1.2);
  EXPECT_EQ(found.velocity, Vec2(-15.5, 0));
  EXPECT_EQ(found.orbit.bounces[0].normal, Vec2(-1, 0));
}

TEST(MovingOrbit, ADiscThatComesIsMetAndReflectsAlongItsNormal) {
  MovingRoom room;
  room.add(Circle{{10, 0}, 1}, {-1, 0});
  const MovingOrbit found = trace_moving_orbit(room, {{0, 0}, {2, 0}}, 0, {5});
  ASSERT_EQ(found.orbit.bounces.size(), 1U);
  EXPECT_EQ(found.times[0].time, 3);
  EXPECT_EQ(found.orbit.bounces[0].point, Vec2(6, 0));
  EXPECT_EQ(found.velocity, Vec2(-4, 0));
  EXPECT_EQ(found.orbit.end, OrbitEnd::escape);
}

TEST(MovingOrbit, InADiscThatMovesStaysWithIt) {
  MovingRoom room;
  room.add(Circle{{0, 0}, 1}, {40, 0});
  const MovingOrbit found = trace_moving_orbit(room, {{0.25, 0.125}, {0.5, 0.25}}, 0, {500});
  ASSERT_EQ(found.orbit.bounces.size(), 500U);
  for (std::size_t i = 0; i < 500; ++i) {
    const Vec2 centre(40 * found.times[i].time, 0);
    EXPECT_NEAR((found.orbit.bounces[i].point - centre).norm(), 1, 1e-11);
    EXPECT_NEAR((found.orbit.bounces[i].out - Vec2(40, 0)).norm(),
                (Vec2(0.5, 0.25) - Vec2(40, 0)).norm(), 1e-9);
  }
}

TEST(MovingOrbit, AmongWallsAtRestIsTheOrbitOfTheFrame) {
  MovingRoom room;
  room.add_ring(kPentagon);
  room.add(Circle{{3, 2}, 0.75});
  const Ray start{{1, 1}, {3, 4}};
  const MovingOrbit found = trace_moving_orbit(room, start, 0, {12});
  const std::vector<Material> mirrors(room.world.surfaces.size(), Material::mirror);
  const Orbit orbit = trace_orbit(room.world.surfaces, mirrors, start, 12);
  ASSERT_EQ(found.orbit.bounces.size(), 12U);
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_EQ(found.orbit.bounces[i].surface, orbit.bounces[i].surface);
    EXPECT_LT((found.orbit.bounces[i].point - orbit.bounces[i].point).norm(), 1e-9);
    EXPECT_NEAR(found.orbit.bounces[i].t, orbit.bounces[i].t, 1e-9);
    EXPECT_NEAR(found.orbit.bounces[i].path_length, orbit.bounces[i].path_length, 1e-9);
  }
}

// Galileo: a room in which all moves alike is the room at rest.
TEST(MovingOrbit, TheWholeRoomMayDrift) {
  for (std::uint64_t item = 0; item < 200; ++item) {
    Draw draw(11, 1, item);
    MovingRoom room;
    room.add_ring(kPentagon);
    room.add(Circle{{3, 2}, 0.5}, {0.25, -0.125});
    const double vx = 4 * draw.unit() - 2, vy = 4 * draw.unit() - 2;
    const double ux = 20 * draw.unit() - 10, uy = 20 * draw.unit() - 10;
    const Vec2 v(vx, vy), u(ux, uy);
    const MovingOrbit rest = trace_moving_orbit(room, {{0.5, 1}, v}, 0, {6});
    const MovingOrbit drift = trace_moving_orbit(drifting(room, u), {{0.5, 1}, v + u}, 0, {6});
    ASSERT_EQ(rest.orbit.bounces.size(), drift.orbit.bounces.size()) << item;
    EXPECT_EQ(rest.orbit.end, drift.orbit.end);
    for (std::size_t i = 0; i < rest.orbit.bounces.size(); ++i) {
      const Bounce &one = rest.orbit.bounces[i], &other = drift.orbit.bounces[i];
      const double time = rest.times[i].time, scale = 1 + time;
      EXPECT_EQ(one.surface, other.surface) << item;
      EXPECT_NEAR(time, drift.times[i].time, 1e-8 * scale) << item << ' ' << i;
      EXPECT_LT((one.point + time * u - other.point).norm(), 1e-7 * scale) << item << ' ' << i;
      EXPECT_LT((one.out + u - other.out).norm(), 1e-7) << item << ' ' << i;
    }
  }
}

TEST(MovingOrbit, RunsBackTheWayItCame) {
  MovingRoom room;
  room.add_ring(kPentagon, {0.125, 0});
  room.add(Segment{{2, 1}, {3, 2.5}}, {0.25, 0.5});
  const MovingOrbit there = trace_moving_orbit(room, {{1, 1}, {3, 6}}, 0, {20, 4});
  ASSERT_EQ(there.end_time, 4);
  ASSERT_GE(there.orbit.bounces.size(), 4U);
  MovingRoom back = room;
  for (std::vector<Leg>& legs : back.motions) {
    legs[0].from += 4 * legs[0].velocity;
    legs[0].velocity *= -1;
  }
  const MovingOrbit again =
      trace_moving_orbit(back, {there.orbit.end_point, -there.velocity}, 0, {20, 4});
  const std::size_t count = there.orbit.bounces.size();
  ASSERT_EQ(again.orbit.bounces.size(), count);
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_EQ(again.orbit.bounces[i].surface, there.orbit.bounces[count - 1 - i].surface);
    EXPECT_NEAR(again.times[i].time, 4 - there.times[count - 1 - i].time, 1e-12);
  }
  EXPECT_LT((again.orbit.end_point - Vec2(1, 1)).norm(), 1e-11);
  EXPECT_LT((again.velocity + Vec2(3, 6)).norm(), 1e-12);
}

// A box closed by a piston that comes at any speed: squeezed into a corner in the end, never out.
TEST(MovingOrbit, NothingTunnelsWhateverTheSpeedOfTheWall) {
  const std::uint64_t items = times(400);
  std::size_t bounces = 0;
  for (std::uint64_t item = 0; item < items; ++item) {
    Draw draw(12, 1, item);
    const double speed = std::pow(10, 20 * draw.unit() - 8),
                 own = std::pow(10, 8 * draw.unit() - 4);
    const double angle = 6.28 * draw.unit();
    MovingRoom room;
    room.add(Segment{{0, 1}, {0, 0}});
    room.add(Segment{{0, 0}, {1, 0}});
    room.add(Segment{{1, 1}, {0, 1}});
    room.add(Segment{{1, -1}, {1, 2}}, {-speed, 0});
    const MovingOrbit found = trace_moving_orbit(
        room, {{0.5, 0.375}, own * Vec2(std::cos(angle), std::sin(angle))}, 0, {2000});
    EXPECT_NE(found.orbit.end, OrbitEnd::escape) << item;
    double before = 0;
    for (std::size_t i = 0; i < found.times.size(); ++i) {
      const Vec2& at = found.orbit.bounces[i].point;
      EXPECT_GE(found.times[i].time, before);
      before = found.times[i].time;
      EXPECT_TRUE(at.x() >= 0 && at.y() >= 0 && at.y() <= 1) << item << ' ' << i;
      EXPECT_LE(at.x(), 1 - speed * before + 4 * kUlp * (1 + speed * before)) << item << ' ' << i;
    }
    bounces += found.times.size();
  }
  EXPECT_GT(bounces, 25 * items);
}

TEST(MovingOrbit, NothingLeavesARoomWhosePistonGoesToAndFro) {
  for (std::uint64_t item = 0; item < 100; ++item) {
    Draw draw(13, 1, item);
    const double period = std::pow(10, 3 * draw.unit() - 3), angle = 6.28 * draw.unit();
    const std::vector<Leg> legs = zigzag(0.3, 0.9, period, 400);
    MovingRoom room;
    room.add(Segment{{0, 1}, {0, 0}});
    room.add(Segment{{0, 0}, {1, 0}});
    room.add(Segment{{1, 1}, {0, 1}});
    room.add(Segment{{0, -1}, {0, 2}}, legs);
    const MovingOrbit found =
        trace_moving_orbit(room, {{0.125, 0.375}, {std::cos(angle), std::sin(angle)}}, 0, {300});
    EXPECT_NE(found.orbit.end, OrbitEnd::escape) << item;
    for (std::size_t i = 0; i < found.times.size(); ++i) {
      const Vec2& at = found.orbit.bounces[i].point;
      EXPECT_TRUE(at.x() >= 0 && at.y() >= 0 && at.y() <= 1) << item << ' ' << i;
      EXPECT_LE(at.x(), place_of(legs, found.times[i].time).x() + 1e-9) << item << ' ' << i;
    }
  }
}

// It comes to x = 3 at time 2 and stands: a particle that is there just then is met on the way.
TEST(MovingOrbit, AWallThatStopsAsItIsMetIsMetAsItComes) {
  MovingRoom room;
  room.add(Segment{{0, -1}, {0, 1}},
           {{0, 2, {5, 0}, {3, 0}, {0, 0}}, {2, kInfinity, {3, 0}, {0, 0}, {0, 0}}});
  const MovingOrbit found = trace_moving_orbit(room, {{1, 0}, {1, 0}}, 0, {5});
  ASSERT_EQ(found.orbit.bounces.size(), 1U);
  EXPECT_EQ(found.times[0].time, 2);
  EXPECT_EQ(found.orbit.bounces[0].point, Vec2(3, 0));
  EXPECT_EQ(found.velocity, Vec2(-3, 0));
  const MovingOrbit later = trace_moving_orbit(room, {{1, 0}, {0.5, 0}}, 0, {5});
  ASSERT_EQ(later.orbit.bounces.size(), 1U);
  EXPECT_EQ(later.times[0].time, 4);
  EXPECT_EQ(later.velocity, Vec2(-0.5, 0));
}

TEST(MovingOrbit, WhatIsRemovedIsNotMet) {
  MovingRoom room = accelerator(-1);
  room.gone_from[2] = 2.25;  // when it would be met
  EXPECT_EQ(trace_moving_orbit(room, {{1, 0}, {3, 0}}, 0, {5}).orbit.end, OrbitEnd::escape);
  room.gone_from[2] = 2.5;
  EXPECT_EQ(trace_moving_orbit(room, {{1, 0}, {3, 0}}, 0, {5}).orbit.bounces.size(), 2U);
}

TEST(MovingOrbit, EndsWhereTwoWallsMeetItAtOneTime) {
  MovingRoom room;
  room.add(Segment{{0, 0}, {100, 0}}, {0, 1});
  room.add(Segment{{0, 8}, {100, 8}}, {0, -1});
  const MovingOrbit found = trace_moving_orbit(room, {{1, 4}, {2, 0}}, 0, {5});
  EXPECT_EQ(found.orbit.end, OrbitEnd::corner);
  EXPECT_EQ(found.end_time, 4);
  EXPECT_EQ(found.orbit.end_point, Vec2(9, 4));
  EXPECT_EQ(found.orbit.end_surfaces, (std::vector<std::uint32_t>{0, 1}));
  EXPECT_TRUE(found.orbit.bounces.empty());
}

TEST(MovingOrbit, EndsAtAnEndOfAWallThatComesAlongItAndAtWhatAbsorbs) {
  MovingRoom room;
  room.add(Segment{{4, 0}, {8, 0}}, {-1, 0});
  const MovingOrbit end = trace_moving_orbit(room, {{0, 0}, {1, 0}}, 0, {5});
  EXPECT_EQ(end.orbit.end, OrbitEnd::corner);
  EXPECT_EQ(end.end_time, 2);
  MovingRoom dark;
  dark.add(Segment{{4, -1}, {4, 1}}, {{0, kInfinity, {0, 0}, {0, 0}, {-1, 0}}}, Material::absorb);
  const MovingOrbit absorbed = trace_moving_orbit(dark, {{0, 0}, {1, 0}}, 0, {5});
  EXPECT_EQ(absorbed.orbit.end, OrbitEnd::absorbed);
  EXPECT_EQ(absorbed.orbit.end_point, Vec2(2, 0));
  EXPECT_EQ(absorbed.end_time, 2);
}

TEST(MovingOrbit, SetsOffFromAWallAsHavingJustLeftIt) {
  const MovingOrbit found = trace_moving_orbit(accelerator(-1), {{0, 0}, {1, 0}}, 0, {1});
  ASSERT_EQ(found.orbit.bounces.size(), 1U);
  EXPECT_EQ(found.times[0].time, 5);
  // With the piston: along it.
  EXPECT_EQ(trace_moving_orbit(accelerator(-1), {{10, 0}, {-1, 1}}, 0, {1}).orbit.end,
            OrbitEnd::along);
  EXPECT_EQ(trace_moving_orbit(accelerator(-1), {{0, 2}, {1, 1}}, 0, {1}).orbit.end,
            OrbitEnd::corner);
}

TEST(MovingOrbit, SetsOffOnTheTangentOfACircleThatMovesAndGoesOn) {
  MovingRoom room;
  room.add(Circle{{0, 0}, 1}, {0, 1});
  room.add(Segment{{5, -9}, {5, 9}});
  const MovingOrbit found = trace_moving_orbit(room, {{0, 1}, {1, 1}}, 0, {1});
  ASSERT_EQ(found.orbit.bounces.size(), 1U);
  EXPECT_EQ(found.orbit.bounces[0].point, Vec2(5, 6));
}

TEST(MovingOrbit, StopsAtATimeAndStartsAtOne) {
  const MovingOrbit found = trace_moving_orbit(accelerator(-1), {{1, 0}, {3, 0}}, 1, {20, 2});
  EXPECT_EQ(found.orbit.end, OrbitEnd::limit);
  EXPECT_EQ(found.end_time, 2);
  EXPECT_EQ(found.orbit.end_point, Vec2(4, 0));
  const MovingOrbit later = trace_moving_orbit(accelerator(-1), {{1, 0}, {3, 0}}, 1, {1});
  EXPECT_EQ(later.times[0].time, 3);  // 1 + 3 (t - 1) = 10 - t
}

}  // namespace
}  // namespace flatray
