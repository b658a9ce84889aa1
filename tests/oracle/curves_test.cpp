#include "oracle/curves.h"

#include <gtest/gtest.h>

#include <cmath>

#include "oracle/families.h"
#include "oracle/nearest.h"

namespace flatray::oracle {
namespace {

Arc whole(const Ellipse& curve) { return {curve, Arc::Extent::whole, {0, 0}, {0, 0}}; }
Arc between(const Ellipse& curve, const Vec2& from, const Vec2& to) {
  return {curve, Arc::Extent::between, from, to};
}
const Circle kFive{{0, 0}, 5};

TEST(RootOf, IsThatAskedForAlsoBehindTheStart) {
  const Ray ray{{0, 3}, {1, 0}};  // meets the circle in (-4, 3) and (4, 3)
  EXPECT_EQ(root_of(ray, kFive, Root::first)->nearest(), -4);
  EXPECT_EQ(root_of(ray, kFive, Root::second)->nearest(), 4);
  EXPECT_EQ(root_of({{11, -2}, {-4, 3}}, kFive, Root::both)->nearest(), 2);
  EXPECT_FALSE(root_of({{0, 6}, {1, 0}}, kFive, Root::first));
}

TEST(FirstMeeting, IsOnceOnATangentAndTwiceOnAChord) {
  const auto tangent = first_wall_hit({{11, -2}, {-4, 3}}, whole(kFive));  // through (3, 4)
  ASSERT_TRUE(tangent);
  EXPECT_EQ(tangent->kind, HitClass::touch);
  EXPECT_EQ(tangent->root, Root::both);
  EXPECT_EQ(tangent->t.nearest(), 2);
  EXPECT_FALSE(first_wall_hit({{11, std::nextafter(-2, 0)}, {-4, 3}}, whole(kFive)));
  const auto outside = first_wall_hit({{-7, 3}, {1, 0}}, whole(kFive));
  EXPECT_EQ(outside->root, Root::first);
  EXPECT_EQ(outside->t.nearest(), 3);
  const auto inside = first_wall_hit({{0, 3}, {1, 0}}, whole(kFive));
  EXPECT_EQ(inside->root, Root::second);
  EXPECT_EQ(inside->t.nearest(), 4);
  const auto on_it = first_wall_hit({{4, 3}, {1, 0}}, whole(kFive));
  EXPECT_EQ(on_it->t.sign(), Sign::zero);
  EXPECT_FALSE(first_wall_hit({{std::nextafter(4, 5), 3}, {1, 0}}, whole(kFive)));
}

TEST(FirstMeeting, OfAnArcIsBetweenItsEnds) {
  const Arc right = between(kFive, {4, -3}, {4, 3}), rest = between(kFive, {4, 3}, {4, -3});
  EXPECT_EQ(first_wall_hit({{-9, 0}, {1, 0}}, right)->t.nearest(), 14);
  EXPECT_EQ(first_wall_hit({{-9, 0}, {1, 0}}, rest)->t.nearest(), 4);
  for (const Arc& arc : {right, rest}) {
    const auto end = first_wall_hit({{9, 3}, {-1, 0}}, arc);
    EXPECT_EQ(end->t.nearest(), 5);
    EXPECT_TRUE(end->at_end);
    EXPECT_EQ(end->kind, HitClass::through);
  }
  const Arc upper = {kFive, Arc::Extent::half, {0, 1}, {0, 0}};
  EXPECT_TRUE(first_wall_hit({{5, -9}, {0, 1}}, upper)->at_end);
  EXPECT_EQ(first_wall_hit({{3, -9}, {0, 1}}, upper)->root, Root::second);
}

// Ends off the circle: what lies between them and it belongs to the arc.
TEST(FirstMeeting, OfWhatJoinsAnEndToItsCurveIsAnEnd) {
  const Arc arc = between(kFive, {7, 0}, {0, 3});
  const auto joint = first_wall_hit({{6, -2}, {0, 1}}, arc);
  ASSERT_TRUE(joint);
  EXPECT_TRUE(joint->at_end);
  EXPECT_EQ(joint->root, Root::none);
  EXPECT_EQ(joint->t.nearest(), 2);
  EXPECT_FALSE(first_wall_hit({{7.5, -2}, {0, 1}}, arc));
  EXPECT_EQ(first_wall_hit({{-2, 4}, {1, 0}}, arc)->t.nearest(), 2);  // inside, towards (0, 3)
  EXPECT_TRUE(first_wall_hit({{6, 0}, {0, 0}}, arc));
  EXPECT_FALSE(first_wall_hit({{0, 2}, {0, 0}}, arc));
}

// (3, 4) and (-4, 3) are half-diameters of the circle of radius 5, too.
TEST(FirstMeeting, OfACircleIsThatOfTheEllipseItIs) {
  const Arc circle = whole(kFive), ellipse = whole(Ellipse({0, 0}, {3, 4}, {-4, 3}));
  const Arc turned = whole(Ellipse({0, 0}, {-4, 3}, {3, 4}));
  Draw draw(11, 0, 0);
  for (int i = 0; i < 200; ++i) {
    const Vec2 from{16 * draw.unit() - 8, 16 * draw.unit() - 8};
    const Ray ray{from, {draw.unit() - 0.5, draw.unit() - 0.5}};
    const auto met = first_wall_hit(ray, circle);
    for (const Arc& other : {ellipse, turned}) {
      const auto same = first_wall_hit(ray, other);
      ASSERT_EQ(met.has_value(), same.has_value());
      if (!met) continue;
      EXPECT_EQ(met->t, same->t);
      EXPECT_EQ(met->root, same->root);
    }
  }
}

TEST(Surd, IsOrderedAsItsSquares) {
  const Surd two{0, 1, 2}, three{0, 1, 3}, less{-3, 1, 20};  // sqrt(20) - 3 = 1.472
  EXPECT_LT(two, less);
  EXPECT_LT(less, three);
  EXPECT_LT((Surd{0, -1, 3}), (Surd{0, -1, 2}));
  EXPECT_EQ((Surd{1, 1, 8}), (two.mapped(1, 2)));
  EXPECT_EQ((Surd{1, -1, 8}), (two.mapped(1, -2)));
  EXPECT_EQ((Surd{-2, 1, 4}).sign(), Sign::zero);
  // 2 (sqrt(3) - sqrt(2)) is sqrt(20 - sqrt(384)): below 0.636 and above 0.635.
  EXPECT_LT(three, two.mapped(0.318, 1));
  EXPECT_GT(three, two.mapped(0.3175, 1));
  EXPECT_EQ(two.nearest(), std::sqrt(2.0));
}

// Walls ruled out by their discs change no answer, and families reach what they are made for.
TEST(RoundFamilies, MeetEveryKindOfHitAndNoneIsLostToBounds) {
  int tangents = 0, firsts = 0, seconds = 0, ends = 0, joints = 0, misses = 0, walls = 0;
  for (const Family& family : families())
    for (std::uint64_t item = 0; item < 4; ++item) {
      const AimedScene scene = make_scene(family, 9, item);
      if (scene.curves.empty()) continue;
      const Surfaces surfaces = scene.surfaces();
      NearestWalls oracle(surfaces);
      for (const Ray& ray : scene.rays) {
        const NearestWall found = oracle.of(ray);
        std::optional<Surd> first;
        std::int64_t number = -1;
        for (std::uint32_t i = 0; i < surfaces.size(); ++i) {
          if (surfaces.segment_slot(i) != kNoSurface) continue;
          const auto met = first_wall_hit(ray, surfaces.arc(i));
          if (!met || (first && !(met->t < *first))) continue;
          first = met->t;
          number = i;
        }
        const bool straight =
            found && surfaces.segment_slot(static_cast<std::uint32_t>(found.wall)) != kNoSurface;
        if (!straight) {
          EXPECT_EQ(found.wall, number) << family.name;
          EXPECT_EQ(found.t, first ? first->nearest() : 0) << family.name;
        }
        const bool curve = found && !straight, none = found.root == Root::none;
        misses += found ? 0 : 1;
        walls += straight ? 1 : 0;
        tangents += found.root == Root::both ? 1 : 0;
        firsts += found.root == Root::first ? 1 : 0;
        seconds += found.root == Root::second ? 1 : 0;
        ends += curve && !none && found.at_end ? 1 : 0;
        joints += curve && none && found.at_end ? 1 : 0;
      }
    }
  for (const int count : {tangents, firsts, seconds, ends, joints, misses, walls})
    EXPECT_GT(count, 10);
}

}  // namespace
}  // namespace flatray::oracle
