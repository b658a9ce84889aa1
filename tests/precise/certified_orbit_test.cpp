// needs: mpfr
#include "precise/certified_orbit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "full_counts.h"
#include "precise/proven_bounces.h"
#include "precise/rooms.h"
#include "transport/periodic_walls.h"

namespace flatray {
namespace {

Surfaces sinai() {
  Surfaces walls = room({{-2, -2}, {2, -2}, {2, 2}, {-2, 2}});
  walls.add(Circle{{0, 0}, 1});
  return walls;
}

TEST(CertifiedOrbit, TheDiamondOfTheSquareIsExact) {
  const Surfaces square = room({{0, 0}, {20, 0}, {20, 20}, {0, 20}});
  const auto orbit = certified_orbit(square, {{15, 5}, {1, 1}}, 400);
  ASSERT_TRUE(orbit);
  EXPECT_TRUE(orbit->decided);
  ASSERT_EQ(orbit->bounces.size(), 400U);
  EXPECT_EQ(orbit->bits, 128U);
  for (std::size_t i = 0; i < 400; ++i) EXPECT_EQ(orbit->bounces[i].surface, (i + 1) % 4);
  EXPECT_EQ(orbit->bounces[399].point, Vec2(10, 0));
}

TEST(CertifiedOrbit, ACornerMetExactlyIsOne) {
  const Surfaces square = room({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  const auto orbit = certified_orbit(square, {{1, 0.5}, {2, 1}}, 9);
  ASSERT_TRUE(orbit);
  // (4, 2), then up and left to (0, 4).
  EXPECT_EQ(orbit->end, OrbitEnd::corner);
  EXPECT_EQ(orbit->bounces.size(), 1U);
  EXPECT_EQ(orbit->end_point, Vec2(0, 4));
  EXPECT_EQ(orbit->end_surfaces, (std::vector<std::uint32_t>{2, 3}));
}

// Squares of its numbers are beyond the doubles, and it takes roots of them.
TEST(CertifiedOrbit, IsDecidedInADiscOfAnySize) {
  for (const double size : {1e155, 1e200, 1e300}) {
    Surfaces walls;
    walls.add(Circle{{size, 0}, size});
    const auto orbit = certified_orbit(walls, {{-3, 0.5}, {1, 0.25}}, 1);
    ASSERT_TRUE(orbit);
    EXPECT_TRUE(orbit->decided) << size;
    ASSERT_EQ(orbit->bounces.size(), 1U);
    EXPECT_EQ(orbit->bounces[0].point.y(), 1.25);  // but for 1e-155 the tangent x = 0
  }
}

TEST(CertifiedOrbit, TwoHundredBouncesAmongDiscsNeedMoreThanDoubles) {
  const auto orbit = certified_orbit(sinai(), {{-1.5, 0.3}, {1, 0.21}}, 200);
  ASSERT_TRUE(orbit);
  EXPECT_TRUE(orbit->decided);
  EXPECT_EQ(orbit->bounces.size(), 200U);
  EXPECT_GT(orbit->bits, 128U);
  for (const CertifiedOrbit::Bounce& bounce : orbit->bounces)
    EXPECT_LE(bounce.point.cwiseAbs().maxCoeff(), 2);
}

// The walls of a longer orbit begin with those of a shorter one, which needs fewer bits.
// Not taken from rounded points, which a hit beside a corner leaves an ulp apart.
TEST(CertifiedOrbit, TimesNormalsAndDirectionsAreThoseOfTheExactOrbit) {
  const Surfaces square = room({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  const auto orbit = certified_orbit(square, {{0.25, 0.5 - 0x1p-54}, {0.75, 0.5}}, 4);
  ASSERT_TRUE(orbit);
  ASSERT_EQ(orbit->bounces.size(), 4U);
  // y is 1 - 2^-54 at x = 1, and 1 another 2^-54 / 0.5 later.
  EXPECT_EQ(orbit->bounces[0].t, 1);
  EXPECT_EQ(orbit->bounces[1].t, 0x1p-53);
  const double length = std::sqrt(0.75 * 0.75 + 0.5 * 0.5);
  EXPECT_EQ(orbit->bounces[1].normal, Vec2(0, -1));
  EXPECT_DOUBLE_EQ(orbit->bounces[1].in.x(), -0.75 / length);
  EXPECT_DOUBLE_EQ(orbit->bounces[1].in.y(), 0.5 / length);
  EXPECT_EQ(orbit->bounces[1].out, Vec2(orbit->bounces[1].in.x(), -orbit->bounces[1].in.y()));
}

TEST(CertifiedOrbit, ReflectsAtTheNormalItTells) {
  const auto orbit = certified_orbit(sinai(), {{0.1, 0.2}, {3, 1}}, 100);
  ASSERT_TRUE(orbit);
  for (const CertifiedOrbit::Bounce& one : orbit->bounces) {
    const Vec2 out = one.in - 2 * one.in.dot(one.normal) * one.normal;
    EXPECT_NEAR((out - one.out).norm(), 0, 1e-15);
    EXPECT_NEAR(one.normal.norm(), 1, 2e-16);
    EXPECT_LT(one.in.dot(one.normal), 0);
  }
}

TEST(CertifiedOrbit, AgreesWithItselfInMoreBits) {
  const Ray start{{-1.5, 0.3}, {1, 0.21}};
  const auto longer = certified_orbit(sinai(), start, 300),
             shorter = certified_orbit(sinai(), start, 40);
  ASSERT_TRUE(longer && shorter);
  EXPECT_GT(longer->bits, shorter->bits);
  for (std::size_t i = 0; i < 40; ++i) {
    EXPECT_EQ(longer->bounces[i].surface, shorter->bounces[i].surface);
    EXPECT_EQ(longer->bounces[i].point, shorter->bounces[i].point);
  }
}

TEST(CertifiedOrbit, BouncesProvenOfTheOrbitInDoublesAreItsOwn) {
  const Surfaces walls = sinai();
  for (int i = 0; i < 20; ++i) {
    const Ray start{{-1.5, 0.3 + 0.01 * i}, {1, 0.21}};
    const Orbit plain = trace_orbit(walls, std::vector(walls.size(), Material::mirror), start, 100);
    const auto truth = certified_orbit(walls, start, 100);
    ASSERT_TRUE(truth);
    std::uint64_t right = 0;
    while (right < plain.bounces.size() && right < truth->bounces.size() &&
           plain.bounces[right].surface == truth->bounces[right].surface)
      ++right;
    EXPECT_LT(right, 100U);  // doubles lose it
    EXPECT_EQ(proven_bounces(walls, plain).bounces, right);
  }
}

// There and back: the orbit turned round at its last point retraces its walls.
TEST(CertifiedOrbit, TurnedRoundItRetracesItsWalls) {
  const Surfaces walls = room({{0, 0}, {7, -1}, {9, 5}, {4, 9}, {-1, 6}});
  const auto there = certified_orbit(walls, {{4, 3}, {3, 1.7}}, 30);
  ASSERT_TRUE(there);
  const Vec2 last = there->bounces[29].point, before = there->bounces[28].point;
  const auto back = certified_orbit(walls, {0.5 * (last + before), before - last}, 20);
  ASSERT_TRUE(back);
  for (std::size_t i = 0; i < 20; ++i)
    EXPECT_EQ(back->bounces[i].surface, there->bounces[28 - i].surface);
}

TEST(CertifiedOrbit, TooFewBitsLeaveItUndecidedAndWhatIsToldIsTrue) {
  const Ray start{{-1.5, 0.3}, {1, 0.21}};
  const auto some = certified_orbit(sinai(), start, 200, {.most_bits = 128}),
             all = certified_orbit(sinai(), start, 200);
  ASSERT_TRUE(some && all);
  EXPECT_FALSE(some->decided);
  EXPECT_LT(some->bounces.size(), 200U);
  EXPECT_GT(some->bounces.size(), 10U);
  for (std::size_t i = 0; i < some->bounces.size(); ++i)
    EXPECT_EQ(some->bounces[i].point, all->bounces[i].point);
}

// Ten bounces among five walls in 128 bits are 10 * 6 * 128 of work: the eleventh is left undecided,
// and so is all that more bits would have told.
TEST(CertifiedOrbit, SpentWorkLeavesItUndecidedWithWhatIsProven) {
  const Surfaces walls = sinai();
  const std::uint64_t step = 128 * (walls.size() + 1);
  const auto orbit =
      certified_orbit(walls, {{-1.5, 0.3}, {1, 0.21}}, 200, {.most_work = 10 * step});
  ASSERT_TRUE(orbit);
  EXPECT_FALSE(orbit->decided);
  EXPECT_EQ(orbit->bounces.size(), 10U);
  EXPECT_TRUE(
      certified_orbit(walls, {{-1.5, 0.3}, {1, 0.21}}, 10, {.most_work = 10 * step})->decided);
}

// A coordinate exactly between two doubles: no number of bits tells to which it rounds.
TEST(CertifiedOrbit, ATieIsRoundedToEvenAndDoesNotStopIt) {
  for (const Ray& start : {Ray{{-0.4, -0.30000000000000004}, {0.1, 0.4}},
                           Ray{{-8.6, -1.9000000000000001}, {-5, -2}}}) {
    const double side = std::fabs(start.origin.x()) < 1 ? 0.4 : 10;
    const auto orbit = certified_orbit(
        room({{-side, -side}, {side, -side}, {side, side}, {-side, side}}), start, 12);
    ASSERT_TRUE(orbit);
    EXPECT_TRUE(orbit->decided);
    EXPECT_LE(orbit->bits, 1024U);
  }
}

// Walls on the ray's own line: ahead a corner, behind nothing, behind another wall nothing.
TEST(CertifiedOrbit, AWallOnTheRaysLineIsACornerOnlyWhereItIsMet) {
  const Ray start{{0, 0}, {1, 0}};
  const auto end_of = [&](const std::vector<Segment>& segments) {
    Surfaces walls;
    for (const Segment& segment : segments) walls.add(segment);
    const auto orbit = certified_orbit(walls, start, 1);
    EXPECT_TRUE(orbit && orbit->decided);
    return orbit->end;
  };
  EXPECT_EQ(end_of({{{2, 0}, {4, 0}}}), OrbitEnd::corner);
  EXPECT_EQ(end_of({{{1, 0}, {1, 0}}, {{2, -1}, {2, 1}}}), OrbitEnd::corner);
  EXPECT_EQ(end_of({{{-4, 0}, {-2, 0}}, {{1, -1}, {1, 1}}}), OrbitEnd::limit);
  EXPECT_EQ(end_of({{{4, 0}, {6, 0}}, {{1, -1}, {1, 1}}}), OrbitEnd::limit);
  EXPECT_EQ(end_of({{{-4, 0}, {-2, 0}}}), OrbitEnd::escape);
}

// The image of the corner (0, 0) in the wall from (3, 0) to (0, 4) is (96, 72) / 25: no number of
// bits says that the ray meets it, and thirds and fifths do.
TEST(CertifiedOrbit, ACornerThatOnlyRationalNumbersTellIsOne) {
  const Surfaces triangle = room({{0, 0}, {3, 0}, {0, 4}});
  const auto orbit = certified_orbit(triangle, {{1, 1}, {71, 47}}, 9);
  ASSERT_TRUE(orbit);
  EXPECT_TRUE(orbit->decided);
  EXPECT_TRUE(orbit->rational);
  EXPECT_EQ(orbit->bounces.size(), 1U);
  EXPECT_EQ(orbit->end, OrbitEnd::corner);
  EXPECT_EQ(orbit->end_point, Vec2(0, 0));
  EXPECT_EQ(orbit->end_surfaces, (std::vector<std::uint32_t>{0, 2}));
  const auto beside = certified_orbit(triangle, {{1, 1}, {71, std::nextafter(47.0, 48.0)}}, 9);
  EXPECT_FALSE(beside->rational);
  EXPECT_EQ(beside->bounces.size(), 9U);
}

// Off walls through the origin the moment stays 1, while directions have 257ths: the orbit goes by
// (16, 1) and (8.03125, 0) to the end of the third wall.
TEST(CertifiedOrbit, BitsOfRationalNumbersAreThoseOfTheLongest) {
  Surfaces walls;
  walls.add(Segment{{0, 0}, {64, 0}});
  walls.add(Segment{{0, 0}, {64, 4}});
  walls.add(Segment{{7.03515625, 0.125}, {7.03515625, 0.25}});
  const auto orbit = certified_orbit(walls, {{32, 1}, {-1, 0}}, 40);
  ASSERT_TRUE(orbit && orbit->decided);
  EXPECT_EQ(orbit->end, OrbitEnd::corner);
  EXPECT_EQ(orbit->bounces.size(), 2U);
  EXPECT_EQ(orbit->end_point, Vec2(7.03515625, 0.125));
  EXPECT_TRUE(orbit->rational);
  EXPECT_GE(orbit->bits, 9U);
}

TEST(CertifiedOrbit, AnAbsorbingWallEndsItWhereItIsMet) {
  const Surfaces square = room({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  std::vector<Material> materials(4, Material::mirror);
  materials[3] = Material::absorb;
  const auto orbit = certified_orbit(square, {{1, 0.5}, {2, 1.5}}, 9, {materials});
  ASSERT_TRUE(orbit);
  EXPECT_EQ(orbit->end, OrbitEnd::absorbed);
  EXPECT_EQ(orbit->bounces.size(), 2U);  // (4, 2.75) and (7/3, 4)
  EXPECT_EQ(orbit->end_point, Vec2(0, 2.25));
  EXPECT_EQ(orbit->end_surfaces, std::vector<std::uint32_t>{3});
}

// A cell of a lattice of discs, and as much of the lattice as the orbit sees.
TEST(CertifiedOrbit, BetweenPeriodicWallsItIsThatOfTheUnfoldedLattice) {
  constexpr int kCells = 12, kBounces = 25;
  const Circle disc{{0.5, 0.5}, 0.375};
  Surfaces cell = room({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), lattice;
  cell.add(disc);
  std::vector<Vec2> shifts;
  for (int x = -kCells; x <= kCells; ++x)
    for (int y = -kCells; y <= kCells; ++y) {
      shifts.emplace_back(x, y);
      lattice.add(Circle{disc.centre + shifts.back(), disc.radius});
    }
  std::vector<Material> materials(5, Material::periodic);
  materials[4] = Material::mirror;
  for (int i = 0; i < (kSanitized ? 2 : 10); ++i) {
    const Ray start{{0.03125 * i, 0.0625}, {1, 0.8125}};
    const auto folded = certified_orbit(cell, start, kBounces, {materials});
    const auto unfolded = certified_orbit(lattice, start, kBounces);
    ASSERT_TRUE(folded && unfolded && folded->decided && unfolded->decided);
    ASSERT_EQ(folded->bounces.size(), unfolded->bounces.size());
    EXPECT_FALSE(folded->crossings.empty());
    for (std::size_t b = 0; b < folded->bounces.size(); ++b) {
      const Vec2 shift = shifts[unfolded->bounces[b].surface];
      EXPECT_LE((unfolded->bounces[b].point - shift - folded->bounces[b].point).norm(), 1e-14);
    }
  }
}

// A flat way below a disc crosses the same wall hundreds of times, and is looked at for a few. Of such
// numbers doubles round nothing.
TEST(CertifiedOrbit, AFlatWayBetweenPeriodicWallsIsNotFollowedCellByCell) {
  Surfaces cell = room({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  cell.add(Circle{{0.5, 0.5}, 0.25});
  std::vector<Material> materials(5, Material::periodic);
  materials[4] = Material::mirror;
  const std::uint64_t few = 40 * 6 * 128;  // flights, of so many walls and bits
  for (const Vec2& way : {Vec2(1, 0x1p-13), Vec2(-1, 0x1p-13), Vec2(1, -0x1p-13)}) {
    for (const bool upright : {false, true}) {
      const Ray start =
          upright ? Ray{{0.15625, 0.125}, {way.y(), way.x()}} : Ray{{0.125, 0.15625}, way};
      const Orbit plain = trace_orbit(cell, materials, start, 1);
      ASSERT_GT(plain.crossings.size(), 400U);
      const auto exact = certified_orbit(cell, start, 1, {materials, kMostBits, few});
      ASSERT_TRUE(exact);
      ASSERT_TRUE(exact->decided);
      ASSERT_EQ(exact->bounces.size(), 1U);
      ASSERT_EQ(exact->crossings.size(), plain.crossings.size());
      for (std::size_t i = 0; i < plain.crossings.size(); ++i) {
        ASSERT_EQ(exact->crossings[i].from, plain.crossings[i].from) << i;
        ASSERT_EQ(exact->crossings[i].to, plain.crossings[i].to) << i;
      }
      EXPECT_NEAR(exact->bounces[0].t, plain.bounces[0].t, 1e-12 * plain.bounces[0].t);
      EXPECT_LE((exact->bounces[0].point - plain.bounces[0].point).norm(), 1e-11);
    }
  }
  const auto on = certified_orbit(cell, {{0.1, 0.15}, {1, 1e-9}}, 1, {materials, kMostBits, few});
  ASSERT_TRUE(on && on->decided);
  EXPECT_EQ(on->end, OrbitEnd::escape);
  EXPECT_EQ(on->crossings.size(), kMostCrossings);
}

// Through the corner of the cell, where both of its walls are crossed at once, for ever.
TEST(CertifiedOrbit, ADiagonalOfAPeriodicCellEscapes) {
  Surfaces cell = room({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  cell.add(Segment{{0.5, 0.25}, {0.75, 0.25}});
  std::vector<Material> materials(5, Material::periodic);
  materials[4] = Material::mirror;
  const auto orbit = certified_orbit(cell, {{0.125, 0.125}, {1, 1}}, 5, {materials});
  ASSERT_TRUE(orbit);
  EXPECT_TRUE(orbit->decided);
  EXPECT_EQ(orbit->end, OrbitEnd::escape);
  ASSERT_EQ(orbit->crossings.size(), 2U);
  EXPECT_EQ(orbit->crossings[0].from, Vec2(1, 1));
  EXPECT_EQ(orbit->crossings[0].to, Vec2(0, 0));
}

TEST(CertifiedOrbit, TheHorizonOfDoublesLiesWhereTheirOrbitIsOffTheRoom) {
  const Surfaces walls = sinai();
  const Ray start{{-1.5, 0.3}, {1, 0.21}};
  const Orbit plain = trace_orbit(walls, std::vector(walls.size(), Material::mirror), start, 100);
  const auto truth = certified_orbit(walls, start, 100);
  ASSERT_TRUE(truth);
  const std::uint64_t reached = horizon(walls, *truth, plain.bounces);
  EXPECT_GT(reached, 20U);
  EXPECT_LE(reached, proven_bounces(walls, plain).bounces);
  EXPECT_EQ(horizon(walls, *truth, {}), 0U);
}

TEST(CertifiedOrbit, AStartOnTheTangentOfACircleGoesOn) {
  Surfaces walls;
  walls.add(Circle{{0, 0}, 1});
  walls.add(Segment{{-2, 3}, {2, 3}});
  const auto orbit = certified_orbit(walls, {{-1, 0}, {0, 1}}, 1);
  ASSERT_TRUE(orbit && orbit->decided);
  ASSERT_EQ(orbit->bounces.size(), 1U);
  EXPECT_EQ(orbit->bounces[0].point, Vec2(-1, 3));
}

// A t beyond the doubles is the largest of them, as in doubles, and no reason to give up: points are told.
TEST(CertifiedOrbit, ATimeBeyondTheDoublesIsTheLargest) {
  for (const double size : {0x1p1023, 0x1p970}) {
    const Surfaces walls = room({{-size, -size}, {size, -size}, {size, size}, {-size, size}});
    const Ray start{{0, 0}, {size == 0x1p970 ? 0x1p-60 : 1, size == 0x1p970 ? 0x1p-62 : 0.25}};
    const auto orbit = certified_orbit(walls, start, 4);
    ASSERT_TRUE(orbit && orbit->decided);
    ASSERT_EQ(orbit->bounces.size(), 4U);
    const Orbit plain =
        trace_orbit(walls, std::vector<Material>(walls.size(), Material::mirror), start, 4);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(orbit->bounces[i].t, plain.bounces[i].t);
      EXPECT_FALSE(std::isnan(plain.bounces[i].path_length));
    }
    EXPECT_EQ(orbit->bounces[1].t, std::numeric_limits<double>::max());
    EXPECT_EQ(orbit->bounces[1].point, Vec2(-size, 0.75 * size));
    EXPECT_EQ(orbit->bounces[3].point, Vec2(size, 0.75 * size));
  }
}

TEST(CertifiedOrbit, AnEscapeHasItsDirectionRounded) {
  Surfaces wall;
  wall.add(Segment{{-5, 0}, {5, 0}});
  const auto orbit = certified_orbit(wall, {{0, 1}, {1, -1}}, 5);
  ASSERT_TRUE(orbit);
  EXPECT_EQ(orbit->end, OrbitEnd::escape);
  EXPECT_EQ(orbit->out, Vec2(0.7071067811865476, 0.7071067811865476));
}

// Of y = x^2 / 4 the focus is (0, 1): the chord from x = a through it ends at -4 / a. The lid sends what comes
// up the axis down again.
TEST(CertifiedOrbit, F5FocusOfAParabola) {
  Surfaces walls;
  walls.add(Bezier({-8, 16}, {0, -16}, {8, 16}));
  walls.add(Segment{{8, 16}, {-8, 16}});
  for (int k = 9; k < 128; k += kSanitized ? 7 : 1) {
    const double a = k / 16.0, b = -4 / a;  // and a^2 without error
    const auto orbit = certified_orbit(walls, {{a, 16}, {0, -1}}, 30);
    ASSERT_TRUE(orbit && orbit->decided);
    ASSERT_EQ(orbit->bounces.size(), 30U);
    const Vec2 at_a(a, a * a / 4), at_b(b, 4 / (a * a));
    const Vec2 points[] = {at_a, at_b, {b, 16}, at_b, at_a, {a, 16}};
    for (std::size_t i = 0; i < 30; ++i) EXPECT_EQ(orbit->bounces[i].point, points[i % 6]) << a;
  }
}

}  // namespace
}  // namespace flatray
