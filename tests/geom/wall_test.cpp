#include "geom/primitives/wall.h"

#include <gtest/gtest.h>

#include "full_counts.h"
#include "geom/curved_path.h"
#include "geom/quick_hit.h"

namespace flatray {
namespace {

// One ellipse, its half-diameters turning either way.
Arc oval(bool clockwise) {
  const Vec2 u(2, 0), v(0, clockwise ? -1 : 1);
  return {Ellipse{{1, 1}, u, v}, Arc::Extent::whole, {0, 0}, {0, 0}};
}

TEST(Walls, NormalsOfAnEllipsePointOutwardWhicheverWayItsHalfDiametersTurn) {
  for (const bool clockwise : {false, true})
    for (const Vec2& out : {Vec2(2, 0), Vec2(-2, 0), Vec2(0, 1), Vec2(0, -1)})
      EXPECT_GT(normal_near(oval(clockwise), Vec2(1, 1) + out).dot(out), 0) << out;
}

// b - a is infinite, and so is no direction.
TEST(Walls, NormalsOfSegmentsLongerThanTheDoublesAreUprightOnThem) {
  const Segment steep{{1, 1e308}, {0, -1e308}}, slope{{1e308, -1.5e308}, {-1e308, 1.5e308}};
  EXPECT_EQ(unit(normal_near(steep, steep.a)), Vec2(1, -5e-309));
  EXPECT_EQ(normal_near(slope, slope.a), Vec2(-1.5e308, -1e308));
  const QuickHit quick = quick_hit({{-1, -9e307}, {2, 1}}, steep);
  EXPECT_TRUE(!quick.is_normal_certain || quick.normal == normal_near(steep, steep.a));
}

TEST(Walls, LeadAwayToTheSideOnWhichTheirNormalIs) {
  const Segment floor{{0, 0}, {4, 0}};
  const Ray up{{1, 0}, {3, 1}}, level{{1, 0}, {1, 0}};
  EXPECT_TRUE(leads_away(floor, Sign::positive, up));
  EXPECT_FALSE(leads_away(floor, Sign::negative, up));
  EXPECT_TRUE(leads_away(floor, Sign::positive, level) && leads_away(floor, Sign::negative, level));
  const Arc disc{Circle{{0, 0}, 5}};
  const Ray out{{3, 4}, {1, 1}}, tangent{{3, 4}, {-4, 3}};
  EXPECT_TRUE(leads_away(disc, Sign::positive, out));
  EXPECT_FALSE(leads_away(disc, Sign::positive, tangent) ||
               leads_away(disc, Sign::negative, tangent));
}

// Arcs between the points with whole coordinates of a circle, and its halves: two overlap where they
// share a stretch from such a point to the next, whichever half-diameters the circle is given by.
TEST(Walls, OverlapWhereTheyShareMoreThanPoints) {
  const Vec2 centre(1, 1);
  const Vec2 places[] = {{5, 0},  {4, 3},   {3, 4},   {0, 5},  {-3, 4}, {-4, 3},
                         {-5, 0}, {-4, -3}, {-3, -4}, {0, -5}, {3, -4}, {4, -3}};
  constexpr int kCount = 12;
  struct Known {
    Arc arc;
    std::array<bool, kCount> stretches{};
  };
  std::vector<Known> all;
  const auto add = [&](const Arc& arc, int from, int count) {
    all.push_back({arc});
    for (int k = 0; k < count; ++k)
      all.back().stretches[static_cast<std::size_t>((from + k) % kCount)] = true;
  };
  const Ellipse round(Circle{centre, 5}), turned(centre, {3, 4}, {-4, 3});
  for (int i = 0; i < kCount; ++i) {
    for (int count = 1; count < kCount; ++count)
      add({count % 2 == 0 ? round : turned, Arc::Extent::between, centre + places[i],
           centre + places[(i + count) % kCount]},
          i, count);
    add({round, Arc::Extent::half, places[(i + 3) % kCount]}, i, 6);
  }
  add({turned}, 0, kCount);
  for (const Known& one : all)
    for (const Known& other : all) {
      bool shared = false;
      for (std::size_t k = 0; k < kCount; ++k) shared |= one.stretches[k] && other.stretches[k];
      ASSERT_EQ(overlap(one.arc, other.arc), shared)
          << &one - all.data() << ' ' << &other - all.data();
    }
  EXPECT_FALSE(overlap(Arc{Circle{centre, 0}}, Arc{Circle{centre, 0}}));
  EXPECT_FALSE(overlap(Arc{round}, Arc{Circle{centre, 4}}));
  EXPECT_TRUE(overlap(Segment{{0, 0}, {2, 2}}, Segment{{3, 3}, {1, 1}}));
  EXPECT_FALSE(overlap(Segment{{0, 0}, {1, 1}}, Segment{{1, 1}, {3, 3}}));
  EXPECT_FALSE(overlap(Segment{{0, 0}, {2, 2}}, Segment{{0, 1}, {2, 3}}));
}

// Arcs that straight edges close, their ends on the curve, inside it and outside: what the half line to the
// right crosses of both, once or not, is what the clip of a ray from the point tells; points beside each
// end, on the level of ends and centre, and on the lines between these.
TEST(Walls, CrossingsOfArcsToTheRightTellTheInside) {
  const Vec2 centre(1, 1);
  const Vec2 ends[] = {{5, 0},  {3, 4}, {0, 5}, {-4, 3}, {-5, 0}, {-3, -4}, {0, -5},
                       {4, -3}, {3, 0}, {0, 4}, {-2, 2}, {-4, 0}, {0, -3},  {2, -2}};
  int inside = 0;
  for (const Ellipse& curve : {Ellipse(Circle{centre, 5}), Ellipse(centre, {3, 4}, {-4, 3})})
    for (const Vec2& one : ends)
      for (const Vec2& other : ends) {
        if (cross(one, other) == 0 && one.dot(other) > 0) continue;
        const Vec2 from = centre + one, to = centre + other;
        const Arc arc{curve, Arc::Extent::between, from, to};
        const CurvedPath path{{{from, to, arc, true, 0}, {to, from, std::nullopt, true, 1}}, true};
        for (double x = -5; x <= 7; x += kSanitized ? 3 : 1)
          for (double y = -5; y <= 7; y += 1) {
            const Vec2 point(x, y);
            if (place_on(arc, point) != PlaceOn::outside ||
                place_on(Segment{to, from}, point) != PlaceOn::outside)
              continue;
            const bool odd =
                crosses_to_right(arc, point) != crosses_to_right(Segment{to, from}, point);
            const std::vector<HitInterval> hits = clip_path({point, {1, 0.3}}, path);
            const bool truth = !hits.empty() && hits.front().start == StartPlace::inside;
            ASSERT_EQ(odd, truth) << point << '\n' << from << '\n' << to;
            inside += odd ? 1 : 0;
          }
      }
  EXPECT_GT(inside, kSanitized ? 3000 : 10000);
}

TEST(Walls, HoldTheirPointsAndEndsWithoutError) {
  const Segment slope{{0, 0}, {3, 1}};
  EXPECT_EQ(place_on(slope, Vec2(3, 1)), PlaceOn::at_end);
  EXPECT_EQ(place_on(slope, Vec2(1.5, 0.5)), PlaceOn::inner);
  EXPECT_EQ(place_on(slope, Vec2(6, 2)), PlaceOn::outside);
  EXPECT_EQ(place_on(slope, Vec2(1, 1.0 / 3)), PlaceOn::outside);  // a third is no double
  const Arc quarter{Circle{{0, 0}, 5}, Arc::Extent::between, {5, 0}, {0, 5}};
  EXPECT_EQ(place_on(quarter, Vec2(3, 4)), PlaceOn::inner);
  EXPECT_EQ(place_on(quarter, Vec2(0, 5)), PlaceOn::at_end);
  EXPECT_EQ(place_on(quarter, Vec2(3, -4)), PlaceOn::outside);
}

// Of an ellipse with conjugate half-diameters u, v a coordinate reaches |(u_k, v_k)| from the centre.
TEST(Walls, BoundsOfAWholeCurveAreNoWiderThanItIs) {
  const auto box = bounds_of(Arc{Circle{{1, 2}, 5}});
  EXPECT_TRUE(box.low.isApprox(Vec2(-4, -3), 1e-14) && box.high.isApprox(Vec2(6, 7), 1e-14));
  const auto oblique =
      bounds_of(Arc{Ellipse{{0, 0}, {3, 5}, {4, -12}}, Arc::Extent::whole, {0, 0}, {0, 0}});
  EXPECT_TRUE(oblique.high.isApprox(Vec2(5, 13), 1e-14));
}

TEST(Walls, BoundsThatAreAddedHoldBoth) {
  Bounds box;
  box.add(bounds_of(Segment{{0, 5}, {2, 3}}));
  box.add(bounds_of(Segment{{1, -1}, {7, 4}}));
  EXPECT_EQ(box.low, Vec2(0, -1));
  EXPECT_EQ(box.high, Vec2(7, 5));
}

TEST(Walls, ASegmentPassesNearItsPointsAndNotNearWhatLiesBeside) {
  const Segment slope{{1, 1}, {5, 7}};
  for (const double t : {0.0, 0.25, 0.5, 1.0}) {
    const Vec2 on = slope.a + t * (slope.b - slope.a);
    EXPECT_TRUE(passes_near(slope, on, Vec2(1e-12, 1e-12))) << t;
    EXPECT_FALSE(passes_near(slope, on + Vec2(3, -2) * 1e-3, Vec2(1e-3, 1e-3))) << t;
    EXPECT_TRUE(passes_near(slope, on + Vec2(3, -2) * 1e-3, Vec2(3e-3, 2e-3))) << t;
  }
}

TEST(Walls, BoundsOfAnArcHoldEndsBesideItsCurve) {
  const Arc wall{Circle{{0, 0}, 1}, Arc::Extent::between, {2, 0}, {0, 3}};
  const Bounds box = bounds_of(wall);
  EXPECT_EQ(box.high, Vec2(2, 3));
  EXPECT_LE(box.low.maxCoeff(), -1);
}

TEST(Walls, AreMetInTheRootsAheadThatWereNotLeft) {
  const Arc disc{Circle{{0, 0}, 1}};
  const auto roots = [&](const Ray& ray, const MeetingRules& rules) {
    std::vector<WallMeeting> met;
    meet(disc, ray, rules, met);
    std::vector<Root> found;
    for (const WallMeeting& each : met) found.push_back(each.root);
    return found;
  };
  const Ray across{{-2, 0}, {1, 0}};
  EXPECT_EQ(roots(across, {}), std::vector{Root::first});
  EXPECT_EQ(roots(across, {.every = true}), (std::vector{Root::first, Root::second}));
  EXPECT_EQ(roots({{-1, 0}, {1, 0}}, {.stood_on = Root::first}), std::vector{Root::second});
  EXPECT_EQ(roots({{-2, 1}, {1, 0}}, {}), std::vector{Root::both});
  EXPECT_TRUE(roots({{-2, 1}, {1, 0}}, {.tangents = false}).empty());
  EXPECT_TRUE(roots({{2, 0}, {1, 0}}, {}).empty());
}

}  // namespace
}  // namespace flatray
