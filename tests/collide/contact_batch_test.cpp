#include "collide/contact_batch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>

#include "collide/certain_contact.h"
#include "collide/kernels/pairs.h"
#include "geom/polygon.h"
#include "oracle/contact.h"
#include "oracle/families.h"
#include "oracle/moving_pairs.h"

namespace flatray {
namespace {

using oracle::Draw;
using Ring = std::vector<Vec2>;

struct Question {
  BodySet shapes;
  std::vector<MovingPair> pairs;

  void add(const Ring& a, const Vec2& va, const Ring& b, const Vec2& vb, double radius_a = 0,
           double radius_b = 0) {
    const std::uint32_t first = shapes.add(a, radius_a), second = shapes.add(b, radius_b);
    pairs.push_back({first, second, va, vb});
  }
  MovingBody a(const MovingPair& pair) const { return shapes.body(pair.a, pair.velocity_a); }
  MovingBody b(const MovingPair& pair) const { return shapes.body(pair.b, pair.velocity_b); }
};

void expect_same_as_one_by_one(const Question& asked, Range within, Isa isa) {
  std::vector<Contact> together(asked.pairs.size());
  contacts(asked.shapes, asked.pairs, within, together, isa);
  for (std::size_t i = 0; i < together.size(); ++i) {
    const MovingPair& pair = asked.pairs[i];
    const Contact alone = contact(asked.a(pair), asked.b(pair), within);
    ASSERT_EQ(together[i], alone) << "pair " << i << ", " << isa_name(isa);
  }
}

// A convex polygon of any sense: corners on an ellipse, or of whole numbers, so that edges and
// motions are often parallel and corners often meet.
Ring polygon(Draw& draw, bool whole) {
  const double x = draw.below(9), y = draw.below(9);
  const Vec2 at(x, y);
  if (whole) {
    const double w = 1 + draw.below(3), h = 1 + draw.below(3), shear = draw.below(2);
    Ring ring = {at, at + Vec2(w, 0), at + Vec2(w + shear, h), at + Vec2(shear, h)};
    if (draw.below(2) == 0) std::reverse(ring.begin(), ring.end());
    return ring;
  }
  const double stretch = 0.25 + draw.unit();
  const int above = 2 + static_cast<int>(draw.below(4)),
            all = above + static_cast<int>(draw.below(4));
  std::vector<double> places;
  for (int i = 0; i < all; ++i) places.push_back(1 - 2 * draw.unit());
  std::sort(places.begin(), places.begin() + above, std::greater());
  std::sort(places.begin() + above, places.end());
  Ring ring;
  for (int i = 0; i < all; ++i) {
    const double p = places[static_cast<std::size_t>(i)], height = stretch * std::sqrt(1 - p * p);
    ring.push_back(at + Vec2(p, i < above ? height : -height));
  }
  return ring;
}

Question questions(std::uint32_t stream, double scale, const Vec2& by) {
  Question asked;
  for (std::uint64_t item = 0; asked.pairs.size() < 1500 && item < 6000; ++item) {
    Draw draw(31, stream, item);
    const bool whole = item % 2 == 0;
    Ring a = polygon(draw, whole), b = polygon(draw, whole);
    for (Ring* ring : {&a, &b})
      for (Vec2& p : *ring) p = scale * p + by;
    if (non_convex_vertex(a) || non_convex_vertex(b)) continue;
    const double ax = draw.below(7) - 3, ay = draw.below(7) - 3;
    const double bx = whole ? draw.below(7) - 3 : draw.unit(), by_way = draw.below(3) - 1;
    asked.add(a, scale * Vec2(ax, ay), b, scale * Vec2(bx, by_way));
  }
  return asked;
}

TEST(ContactBatch, GivesTheBitsOfOnePairACallOnEveryTier) {
  const Question asked = questions(40, 1, {0, 0});
  for (const Isa isa : available_isas())
    for (const Range within : {kSegment, kRay, Range{0, 7}, kLine, Range{0.25, 2}})
      expect_same_as_one_by_one(asked, within, isa);
}

TEST(ContactBatch, GivesTheSameBitsFarAwayAndAtEveryScale) {
  for (const double scale : {1e-300, 0x1p-70, 1e-9, 1e12, 0x1p59, 1e150})
    expect_same_as_one_by_one(questions(41, scale, {0, 0}), kSegment, active_isa());
  for (const Vec2& far : {Vec2(0x1p40, -0x1p39), Vec2(1e15, 1), Vec2(-3, 1e9)})
    expect_same_as_one_by_one(questions(42, 1, far), kRay, active_isa());
}

TEST(ContactBatch, TakesWhatTheLanesDoNot) {
  Question asked;
  Ring round;
  for (int i = 0; i < 9; ++i)
    round.emplace_back(i - 4.0, (i - 4.0) * (i - 4.0));  // nine corners on a parabola
  const Ring point = {{0.5, 3}}, segment = {{0, 3}, {1, 3}},
             square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (const Ring& a : {round, point, segment, square})
    for (const Ring& b : {round, point, segment, square})
      for (const Vec2& way : {Vec2(0, 0), Vec2(0, -1), Vec2(1e-200, 0), Vec2(1e200, 1e200)})
        asked.add(a, way, b, {0, 0});
  for (const Range within : {kSegment, kRay, Range{0, 0}, Range{1, 0}})
    expect_same_as_one_by_one(asked, within, active_isa());
}

// Boxes rule out what no lane takes, and nothing that touches.
TEST(ContactBatch, TakesWhatIsRoundAtEveryScaleAndFarAway) {
  for (const double scale : {1e-300, 1.0, 1e150})
    for (const Vec2& far : {Vec2(0, 0), Vec2(0x1p40, -0x1p39)}) {
      Question asked;
      for (std::uint64_t item = 0; item < 500; ++item) {
        Draw draw(31, 46, item);
        const auto ring = [&]() -> Ring {
          const double x = draw.below(9), y = draw.below(9);
          const Vec2 at = scale * (Vec2(x, y) + far);
          if (draw.below(2) == 0) return {at};
          return {at, at + scale * Vec2(1, 0)};
        };
        const double r = scale * draw.below(3), s = scale * draw.below(2);
        const double vx = draw.below(7) - 3, vy = draw.below(7) - 3;
        const Ring one = ring(), other = ring();
        asked.add(one, {0, 0}, other, scale * Vec2(vx, vy), r, s);
      }
      for (const Range within : {kSegment, kRay})
        expect_same_as_one_by_one(asked, within, active_isa());
    }
}

// A corner within rounding of a slanted side at t = 0: the high part of what tells its side has no sign of
// its own.
TEST(ContactBatch, TellsCornersThatStartNextToASlantedSide) {
  Question asked;
  asked.add(
      {{-1.1492453445402577, -1.844733897005363}, {1.294812926211971, 1.4531549134999762}, {-3, 2}},
      {0, 0}, {{0.0039007808442927186, -0.28873674698126395}, {3, -2}, {3, 0}}, {1, 0});
  asked.add({{0, 0}, {1 + 0x1p-29, 1 + 0x1p-30}, {-1, 2}}, {0, 0},
            {{(1 + 0x1p-30) / 2, 0.5}, {3, -1}, {3, 1}}, {-1, 0});
  const auto& families = oracle::straight_families();
  for (std::uint64_t item = 0; item < 3000; ++item) {
    const oracle::StraightPair pair = make_pair(families.back(), 5, item);
    asked.add(pair.ring_a, pair.velocity_a, pair.ring_b, pair.velocity_b);
  }
  for (const Isa isa : available_isas())
    for (const Range within : {kSegment, kRay, kLine})
      expect_same_as_one_by_one(asked, within, isa);
}

TEST(ContactBatch, AgreesWithSeparatingAxes) {
  const Question asked = questions(43, 1, {0, 0});
  std::vector<Contact> met(asked.pairs.size());
  contacts(asked.shapes, asked.pairs, kSegment, met);
  int hits = 0;
  for (std::size_t i = 0; i < met.size(); ++i) {
    const MovingPair& pair = asked.pairs[i];
    const oracle::ContactTruth truth =
        oracle::contact_truth({asked.a(pair).vertices, pair.velocity_a},
                              {asked.b(pair).vertices, pair.velocity_b}, kSegment);
    ASSERT_EQ(met[i].times.kind, truth.kind) << i;
    ASSERT_EQ(met[i].times.start, truth.start) << i;
    if (!met[i].times) continue;
    ++hits;
    ASSERT_EQ(met[i].times.t_enter, truth.first->nearest()) << i;
    ASSERT_EQ(met[i].times.t_exit, truth.last->nearest()) << i;
  }
  EXPECT_GT(hits, 200);
}

TEST(ContactBatch, AxisParallelBoxesMeetAtTheClosedForm) {
  const Ring square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  Question asked;
  for (const double x : {-5.0, -2.5, 2.25, 7.0})
    for (const double y : {-0.75, 0.125, 0.5})
      asked.add(square, {0, 0}, {{x, y}, {x + 2, y}, {x + 2, y + 1}, {x, y + 1}},
                {x < 0 ? 3 : -3, 0});
  std::vector<Contact> met(asked.pairs.size());
  contacts(asked.shapes, asked.pairs, kRay, met);
  for (std::size_t i = 0; i < met.size(); ++i) {
    const double x = asked.b(asked.pairs[i]).vertices[0].x();
    EXPECT_EQ(met[i].times.kind, HitClass::through) << i;
    EXPECT_EQ(met[i].times.t_enter, (x < 0 ? -2 - x : x - 1) / 3) << i;
    EXPECT_EQ(met[i].times.t_exit, (x < 0 ? 1 - x : x + 2) / 3) << i;
  }
}

// Parallelograms with the directions of their edges in common, turned and exact: edges that face
// each other lie on one line when they meet.
Question parallel_edges() {
  Question asked;
  for (std::uint64_t item = 0; item < 600; ++item) {
    Draw draw(31, 44, item);
    const double cx = 3 - draw.below(7), cy = 1 + draw.below(4), sx = 1 + draw.below(3);
    const Vec2 along(cx, cy), across(-sx, draw.below(2));
    Ring rings[2];
    for (Ring& ring : rings) {
      const double x = draw.below(40) - 20, y = draw.below(40) - 20, l = 1 + draw.below(4);
      const Vec2 at = Vec2(x, y) / 4;
      ring = {at, at + l * along, at + l * along + across, at + across};
    }
    if (non_convex_vertex(rings[0]) || non_convex_vertex(rings[1])) continue;
    const double vx = draw.unit(), vy = draw.unit();
    asked.add(rings[0], {0, 0}, rings[1], 9 * Vec2(vx - 0.5, vy - 0.5));
  }
  return asked;
}

TEST(ContactBatch, FacingEdgesGiveTheBitsOfOnePairACallOnEveryTier) {
  const Question asked = parallel_edges();
  EXPECT_GT(asked.pairs.size(), 400U);
  for (const Isa isa : available_isas())
    for (const Range within : {kSegment, kRay}) expect_same_as_one_by_one(asked, within, isa);
}

// Proves the entry of a pair for a time that ends while they overlap, from each edge and corner that
// can be named; how many of them are decided.
int decided(const Question& asked, std::size_t i) {
  const MovingPair& pair = asked.pairs[i];
  for (const std::uint32_t shape : {pair.a, pair.b})
    if (!asked.shapes.is_ready(shape)) return -1;
  const MovingBody a = asked.a(pair), b = asked.b(pair);
  const HitInterval all = contact(a, b).times;
  if (all.kind != HitClass::through || all.start != StartPlace::outside) return -1;
  const double length = 0.5 * all.t_enter + 0.5 * all.t_exit;
  const Contact alone = contact(a, b, {0, length});
  CertainContacts certain(asked.shapes, length, pairs::kPortable.certify);
  int count = 0;
  for (unsigned guess = 0; guess <= pairs::kCandidateBits; ++guess) {
    const float named = std::bit_cast<float>(std::bit_cast<unsigned>(1.0F) | guess);
    Contact met;
    bool left = false;
    certain.add(pair, {named, -2, 1, -1}, met);
    certain.run([&](const MovingPair&, Contact&) { left = true; });
    if (left) continue;
    ++count;
    EXPECT_EQ(met, alone) << "pair " << i << ", guess " << guess;
  }
  return count;
}

TEST(CertainContacts, AnyGuessIsPutRightOrLeftUndecided) {
  const Question asked = questions(45, 1, {0, 0});
  int some = 0;
  for (std::size_t i = 0; i < asked.pairs.size(); ++i) some += decided(asked, i) > 0 ? 1 : 0;
  EXPECT_GT(some, 100);
}

TEST(CertainContacts, FacingEdgesAreProvenFromAGuessNearby) {
  const Question asked = parallel_edges();
  int meet = 0;
  for (std::size_t i = 0; i < asked.pairs.size(); ++i) {
    const int count = decided(asked, i);
    meet += count >= 0 ? 1 : 0;
    EXPECT_NE(count, 0) << "pair " << i;
  }
  EXPECT_GT(meet, 50);
}

}  // namespace
}  // namespace flatray
