#include "geom/quick_hit.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "geom/clip_cases.h"
#include "geom/exact_hit.h"
#include "geom/primitives/wall.h"

namespace flatray {
namespace {

double signed_number(Draw& draw) { return draw.sign() * (1 + draw.unit()); }

// About `offset`, some `size` apart.
Vec2 place(Draw& draw, double offset, double size) {
  const double x = offset + size * signed_number(draw), y = offset - size * signed_number(draw);
  return {x, y};
}

struct Count {
  int hits = 0, points = 0, normals = 0, sides = 0, asked = 0;
  template <class Wall>
  void see(const QuickHit& quick, const ExactHit& exact, const Wall& wall) {
    ++hits;
    if (!quick.is_certain) return;
    ++points;
    EXPECT_EQ(quick.nearest, exact.nearest());
    for (int j = -2; j <= 2; ++j)
      for (int i = -2; i <= 2; ++i) {
        Vec2 point = quick.nearest;
        for (int k = 0; k < std::abs(i); ++k) point.x() = std::nextafter(point.x(), i * kInfinity);
        for (int k = 0; k < std::abs(j); ++k) point.y() = std::nextafter(point.y(), j * kInfinity);
        const auto side = side_by_hit(wall, quick, point);
        ++asked;
        if (!side) continue;
        ++sides;
        EXPECT_EQ(*side, side_of(wall, point));
      }
  }
};

// Scales and offsets of which some leave few bits, or none, of what is drawn.
struct WallFamily {
  double offset, size;
};
constexpr WallFamily kWallFamilies[] = {{0, 1},     {1, 1},       {1e6, 1},    {1, 1e-9},
                                        {0, 1e-60}, {1e60, 1e58}, {0, 1e-150}, {1e150, 1e140}};

TEST(QuickHit, OfASegmentIsTheExactPointAndSideOrSaysThatItIsInDoubt) {
  Count count;
  for (int item = 0; item < 4000; ++item) {
    Draw draw = draw_of(90, item);
    const WallFamily& family = kWallFamilies[item % 8];
    const Vec2 a = place(draw, family.offset, family.size);
    Vec2 b = place(draw, family.offset, family.size);
    if (item % 5 == 1) b.x() = a.x();  // upright
    if (item % 5 == 2) b.y() = a.y();
    const Ray ray{place(draw, family.offset, family.size), place(draw, 0, 1)};
    if (a == b || turn_from_edge(a, b, ray.direction) == Sign::zero) continue;
    count.see(quick_hit(ray, Segment{a, b}), ExactHit(ray, Segment{a, b}), Segment{a, b});
  }
  fmt::print("{} of {} points, {} of {} sides\n", count.points, count.hits, count.sides,
             count.asked);
  EXPECT_GT(count.points, 0.7 * count.hits);  // two families in eight lie beyond sound sizes
  EXPECT_GT(count.sides, 0.99 * count.asked);
}

TEST(QuickHit, OfACurveIsTheExactPointAndSideOrSaysThatItIsInDoubt) {
  Count count;
  for (int item = 0; item < 4000; ++item) {
    Draw draw = draw_of(91, item);
    const WallFamily& family = kWallFamilies[item % 8];
    const Vec2 centre = place(draw, family.offset, family.size);
    const Vec2 u = place(draw, 0, family.size), v = place(draw, 0, family.size);
    const bool round = item % 3 == 0;
    const Arc wall{round ? Ellipse(Circle{centre, family.size * (1 + draw.unit())})
                         : Ellipse(centre, u, v)};
    const Ray ray{place(draw, family.offset, family.size), place(draw, 0, 1)};
    const auto met = hit_curve(ray, wall.curve);
    if (!met || met->tangent || cross_sign(u, v) == Sign::zero) continue;
    for (const auto root : {Root::first, Root::second}) {
      const QuickHit quick = quick_hit(ray, wall, root);
      const ExactHit exact(ray, wall, root);
      count.see(quick, exact, wall);
      if (!quick.is_normal_certain) continue;
      ++count.normals;
      EXPECT_EQ(quick.normal, exact.normal());
    }
  }
  fmt::print("{} of {} points, {} normals, {} of {} sides\n", count.points, count.hits,
             count.normals, count.sides, count.asked);
  EXPECT_GT(count.points, 0.5 * count.hits);
  EXPECT_GT(count.normals, 0.5 * count.hits);
  EXPECT_GT(count.sides, 0.97 * count.asked);
}

// Where a wall is upright or level its points are without error: on it is a certain answer.
TEST(QuickHit, KnowsThatAPointIsOnAnUprightOrLevelWall) {
  for (const double place : {0.0, -0.0, 0.1, 5e-324, 1e300}) {
    const Segment upright{{place, -1}, {place, 2}}, level{{2, place}, {-1, place}};
    const QuickHit at_upright = quick_hit({{place + 1, 0.3}, {-1, 0.01}}, upright);
    const QuickHit at_level = quick_hit({{0.3, place + 1}, {0.01, -1}}, level);
    // At 1e300 that takes a compiler which sees that the low parts of doubles are 0: else it is in doubt.
    if (place == 1e300 && !(at_upright.is_certain && at_level.is_certain)) continue;
    ASSERT_TRUE(at_upright.is_certain && at_level.is_certain);
    EXPECT_FALSE(std::signbit(at_upright.nearest.x()));
    EXPECT_EQ(side_by_hit(upright, at_upright, at_upright.nearest), Sign::zero);
    EXPECT_EQ(side_by_hit(level, at_level, at_level.nearest), Sign::zero);
    const Vec2 beside(std::nextafter(place, kInfinity), at_upright.nearest.y());
    EXPECT_EQ(side_by_hit(upright, at_upright, beside), Sign::negative);
  }
}

TEST(QuickHit, OfNoSoundNumberIsInDoubt) {
  EXPECT_FALSE(quick_hit({{0, 0}, {1, 0}}, Segment{{1, -1}, {2, -1}}).is_certain);  // parallel
  EXPECT_FALSE(
      quick_hit({{0, 0}, {1e308, 1e308}}, Segment{{1e308, -1e308}, {1e307, 1e308}}).is_certain);
  EXPECT_FALSE(quick_hit({{0, 2}, {1, 0}}, Arc{Circle{{0, 0}, 1}}, Root::first).is_certain);
}

}  // namespace
}  // namespace flatray
