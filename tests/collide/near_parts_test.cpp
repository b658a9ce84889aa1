#include "collide/near_parts.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "oracle/families.h"

namespace flatray {
namespace {

using oracle::Draw;
using Parts = std::vector<ShapePart>;

// Points, segments, triangles, discs and capsules; on a lattice, so that many only touch, or anywhere. A few are
// large.
Parts some_parts(Draw& draw, int count, double far, bool on_lattice) {
  const auto coordinate = [&](double size) {
    const double x = size * (draw.unit() - 0.5);
    return on_lattice ? std::round(x) : x;
  };
  Parts parts;
  for (int i = 0; i < count; ++i) {
    const double x = coordinate(40), y = coordinate(40), size = draw.unit() < 0.05 ? 30 : 4;
    ShapePart part;
    for (int k = 0; k <= i % 3; ++k) {
      const double dx = coordinate(size), dy = coordinate(size);
      part.ring.emplace_back(far + x + dx, y + dy);
    }
    if (draw.unit() < 0.3) part.radius = on_lattice ? 1 : draw.unit();
    parts.push_back(std::move(part));
  }
  return parts;
}

TEST(NearParts, NoneIsLeftOutThatMeets) {
  std::size_t met = 0, asked = 0, all = 0;
  for (std::uint64_t item = 0; item < 120; ++item) {
    Draw draw(57, 1, item);
    const double far = item % 4 == 3 ? 1e15 : 0;
    const bool on_lattice = item % 2 == 1;
    const Parts a = some_parts(draw, 40, far, on_lattice),
                b = some_parts(draw, 40, far, on_lattice);
    const auto speed = [&] { return on_lattice ? std::round(6 * draw.unit() - 3) : draw.unit(); };
    const double ax = speed(), ay = speed(), bx = speed(), by = speed();
    const Vec2 of_a(ax, ay), of_b(bx, by);
    const Range within{item % 5 == 0 ? 0.5 : 0, item % 3 == 0 ? 0.5 : 1.0};
    const NearParts near(b);
    for (const ShapePart& p : a) {
      const std::vector<std::size_t> found = near.near(p, of_a - of_b, within);
      EXPECT_TRUE(std::ranges::is_sorted(found));
      asked += found.size();
      all += b.size();
      for (std::size_t q = 0; q < b.size(); ++q) {
        if (!contact({p.ring, of_a, p.radius}, {b[q].ring, of_b, b[q].radius}, within).times)
          continue;
        ++met;
        EXPECT_TRUE(std::ranges::binary_search(found, q)) << item;
      }
    }
  }
  EXPECT_GT(met, 1500U);
  EXPECT_LT(2 * asked, all);
}

// Teeth of two combs that slide past each other.
TEST(NearParts, OfManyThatMoveALittleOnlyNeighboursAreAsked) {
  for (const std::size_t count : {100U, 1000U, 10000U}) {
    Parts teeth;
    for (std::size_t i = 0; i < count; ++i) {
      const double x = 3 * static_cast<double>(i);
      teeth.push_back({{{x, 0}, {x, 1}}});
    }
    const NearParts near(teeth);
    std::size_t asked = 0;
    for (const ShapePart& tooth : teeth) asked += near.near(tooth, {1, 0}, {0, 2}).size();
    EXPECT_EQ(asked, count);
  }
}

TEST(NearParts, WhereBoxesTellNothingAllAre) {
  Parts parts(20, ShapePart{{{0, 0}, {1, 0}}});
  const NearParts near(parts);
  const ShapePart away{{{9, 9}}}, huge{{{1e308, 0}}, 1e308};
  const ShapePart curved{{}, 0, Ellipse{{9, 9}, {1, 0}, {0, 0.5}}};
  EXPECT_EQ(near.near(away, {0, 0}, {0, 1}).size(), 0U);
  EXPECT_EQ(near.near(away, {0, 0}, {-1, 1}).size(), 20U);
  EXPECT_EQ(near.near(away, {0, 0}, kRay).size(), 20U);
  EXPECT_EQ(near.near(away, {-kInfinity, 0}, {0, 0}).size(), 20U);
  EXPECT_EQ(near.near(huge, {-1e308, 0}, {0, 2}).size(), 20U);
  EXPECT_EQ(near.near(curved, {0, 0}, {0, 1}).size(), 20U);
  parts.back() = curved;
  EXPECT_EQ(NearParts(parts).near(away, {0, 0}, {0, 1}), std::vector<std::size_t>{19});
}

}  // namespace
}  // namespace flatray
