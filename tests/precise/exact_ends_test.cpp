// needs: mpfr
// Ends that a ray meets exactly, in coordinates that hold it.
#include <gtest/gtest.h>

#include <bit>
#include <tuple>

#include "precise/ball.h"
#include "precise/certified_orbit.h"
#include "precise/rooms.h"

namespace flatray {
namespace {

// (1 + 2^-200) - 1, of a number that held 128 bits before.
TEST(Ball, TakesTheBitsOfWhatItIsSetTo) {
  const Ball one(1, 256);
  const Ball more = one + Ball(0x1p-200, 256);
  Ball set(7, 128);
  set = more;
  EXPECT_EQ((set - one).sign(), Sign::positive);
  const Ball copy(set);
  EXPECT_EQ((copy - one).sign(), Sign::positive);
}

TEST(CertifiedOrbit, AWallOnTheRaysLineIsMetAtTheEndThatIsNearer) {
  for (const double way : {1.0, -1.0})
    for (const bool turned : {false, true}) {
      const Vec2 near(2 * way, 0), far(4 * way, 0);
      Surfaces walls;
      walls.add(turned ? Segment{far, near} : Segment{near, far});
      const auto orbit = certified_orbit(walls, {{0, 0}, {way, 0}}, 1);
      ASSERT_TRUE(orbit && orbit->decided);
      EXPECT_EQ(orbit->end, OrbitEnd::corner);
      EXPECT_EQ(orbit->end_point, near);
    }
}

// y = 1 touches three quarters of the unit circle in the end (0, 1), and the other way in nothing but it.
TEST(CertifiedOrbit, AnArcIsMetInTheEndWhereTheRayTouchesIt) {
  Surfaces walls;
  walls.add(Arc{Circle{{0, 0}, 1}, Arc::Extent::between, {0, 1}, {1, 0}});
  for (const double way : {1.0, -1.0}) {
    const auto orbit = certified_orbit(walls, {{-way, 1}, {way, 0}}, 4);
    ASSERT_TRUE(orbit && orbit->decided);
    EXPECT_EQ(orbit->end, OrbitEnd::corner);
    EXPECT_EQ(orbit->end_point, Vec2(0, 1));
  }
  const auto beside = certified_orbit(walls, {{-1, -1}, {0, 1}}, 4);  // x = -1, between the ends
  ASSERT_TRUE(beside && beside->decided);
  EXPECT_EQ(beside->end, OrbitEnd::escape);
}

TEST(CertifiedOrbit, AWallOnTheRaysLineIsMetBeforeOneThatCrossesIt) {
  for (const bool turned : {false, true}) {
    Surfaces walls;
    walls.add(turned ? Segment{{4, 0}, {2, 0}} : Segment{{2, 0}, {4, 0}});
    walls.add(Segment{{3, -1}, {3, 1}});
    const auto orbit = certified_orbit(walls, {{0, 0}, {1, 0}}, 1);
    ASSERT_TRUE(orbit && orbit->decided);
    EXPECT_EQ(orbit->end, OrbitEnd::corner);
    EXPECT_EQ(orbit->end_surfaces, std::vector<std::uint32_t>{0});
    EXPECT_EQ(orbit->end_point, Vec2(2, 0));
  }
}

// The last doubling of the first bits is what was asked for, not a bit more.
TEST(CertifiedOrbit, MostBitsAreReachedByDoubling) { EXPECT_TRUE(std::has_single_bit(kMostBits)); }

// Doubles for 0.6 and 0.8 lie off the circle, those for 1.8 and 0.8 off the ellipse. The line by them
// to the other end, which is on the curve, meets them first; where it meets the ellipse no number of
// bits tells.
TEST(CertifiedOrbit, AnEndOffItsCurveIsACornerWhateverLiesBeyond) {
  const Ellipse ellipse({0, 0}, {3, 0}, {0, 1});
  for (const auto& [curve, from, to] :
       {std::tuple(Ellipse(Circle{{0, 0}, 1}), Vec2(0.6, 0.8), Vec2(1, 0)),
        std::tuple(ellipse, Vec2(1.8, 0.8), Vec2(3, 0))})
    for (const bool ends_there : {false, true}) {
      const Vec2 way(to - from);
      Surfaces walls;
      walls.add(ends_there ? Arc{curve, Arc::Extent::between, to, from}
                           : Arc{curve, Arc::Extent::between, from, to});
      const auto orbit = certified_orbit(walls, {from - way, way}, 1, {.most_bits = 512});
      ASSERT_TRUE(orbit);
      EXPECT_TRUE(orbit->decided);
      EXPECT_EQ(orbit->end, OrbitEnd::corner);
      EXPECT_EQ(orbit->end_point, from);
    }
}

}  // namespace
}  // namespace flatray
