// Pixels that several items share: what each shows is known from exact areas of unions.
#include <gtest/gtest.h>

#include "full_counts.h"
#include "render/coverage_families.h"
#include "render/seen_area.h"

namespace flatray {
namespace {

using coverage_check::add_ring;
using coverage_check::convex;
using coverage_check::Draws;
using coverage_check::Family;
using coverage_check::kFrame;
using coverage_check::point;
using coverage_check::ring_path;
using coverage_check::SeenArea;

DrawList on_black(std::vector<DrawItem> items, int side = 9, Coverage coverage = Coverage::area) {
  return {side, side, {0, 0, 0, 1}, coverage, std::move(items)};
}

double largest_difference(const DrawList& a, const DrawList& b) {
  const LinearImage one = render_linear(a, {}), other = render_linear(b, {});
  double largest = 0;
  for (std::size_t i = 0; i < one.pixels.size(); ++i)
    largest = std::max(largest, std::abs(static_cast<double>(one.pixels[i]) -
                                         static_cast<double>(other.pixels[i])));
  return largest;
}

// Items of a scene as the oracle has them: the convex pieces of each.
struct Overlapping {
  DrawList list = on_black({});
  std::vector<std::vector<std::vector<Vec2>>> pieces;

  void add(std::vector<std::vector<Vec2>> item, float shade) {
    DrawItem drawn;
    FillPath path;
    for (const auto& piece : item) add_ring(piece, false, path);
    path.simple = item.size() == 1;
    drawn.region = std::move(path);
    drawn.colour = {shade, 1 - shade, 0, 1};
    list.items.push_back(std::move(drawn));
    pieces.push_back(std::move(item));
  }
};

// A stroke along three points: two boxes that overlap at the joint.
std::vector<std::vector<Vec2>> stroke(Draws& draws) {
  std::vector<std::vector<Vec2>> boxes;
  Vec2 from(9 * draws.unit(), 9 * draws.unit());
  for (int leg = 0; leg < 2; ++leg) {
    const Vec2 to(9 * draws.unit(), 9 * draws.unit());
    const Vec2 side = 0.4 * draws.unit() * Vec2(from.y() - to.y(), to.x() - from.x()) / 9;
    boxes.push_back(coverage_check::hull({from - side, to - side, to + side, from + side}));
    from = to;
  }
  return boxes;
}

// How far pictures are from what is known.
struct Errors {
  double worst = 0, sum = 0;
  std::uint64_t count = 0;

  void add(double error) {
    worst = std::max(worst, error);
    sum += error;
    ++count;
  }
  void print(const char* of) const {
    fmt::print("{} {}, largest error {:.2g}, mean {:.2g}\n", count, of, worst,
               sum / static_cast<double>(count));
  }
};

// What is seen of an item is its share of the union with those above it beyond theirs.
TEST(JointCoverage, OpaqueItemsAreSeenAsFarAsNoneAboveCoversThem) {
  Errors errors, of_integrals;
  for (std::uint64_t item = 0; item < times(60); ++item) {
    Draws draws(17, item);
    Overlapping scene;
    SeenArea integrals;
    const int items = 2 + draws.below(4);
    for (int i = 0; i < items; ++i)
      if (draws.below(2) == 0)
        scene.add({convex(Family::random, draws)}, static_cast<float>(draws.unit()));
      else
        scene.add(stroke(draws), static_cast<float>(draws.unit()));
    for (std::size_t i = 0; i < scene.pieces.size(); ++i)
      for (const auto& piece : scene.pieces[i]) integrals.add_polygon(piece, i);
    const LinearImage picture = render_linear(scene.list, {});
    for (int y = 0; y < kFrame.height; ++y)
      for (int x = 0; x < kFrame.width; ++x) {
        const auto seen = integrals.in_pixel(x, y, scene.pieces.size());
        std::vector<std::vector<Vec2>> above;
        Rational covered = 0;
        double red = 0;
        for (std::size_t i = scene.pieces.size(); i-- > 0;) {
          above.insert(above.end(), scene.pieces[i].begin(), scene.pieces[i].end());
          const Rational all = exact_union_area(above, x, y);
          const double share = (all - covered).nearest();
          red += share * static_cast<double>(scene.list.items[i].colour.r);
          of_integrals.add(std::abs(static_cast<double>(seen[i]) - share));
          covered = all;
        }
        const auto at = 3 * static_cast<std::size_t>(y * kFrame.width + x);
        const double error = std::abs(static_cast<double>(picture.pixels[at]) - red);
        ASSERT_LE(error, 1e-6) << "scene " << item << " pixel " << x << ", " << y;
        errors.add(error);
      }
  }
  errors.print("pixels");
  of_integrals.print("integrals");
  EXPECT_LE(of_integrals.worst, 1e-14) << "what tests of discs compare with";
}

// Items of every kind, on no grid, on tenths and on pixels' corners. Rationals have no discs: integrals
// in closed form, which the test above holds against them.
TEST(JointCoverage, PolygonsStrokesAndDiscsAreSeenAsFarAsIntegralsSay) {
  Errors errors;
  constexpr std::array kGrids{Family::random, Family::decimal, Family::corner};
  for (std::uint64_t item = 0; item < times(10000, 150); ++item) {
    Draws draws(29, item);
    Overlapping scene;
    SeenArea integrals;
    const Family grid = kGrids[item % kGrids.size()];
    const std::size_t items = 2 + static_cast<std::size_t>(draws.below(5));
    for (std::size_t i = 0; i < items; ++i) {
      const float shade = static_cast<float>(draws.unit());
      const int kind = draws.below(3);
      if (kind == 2) {
        const Vec2 centre = point(grid, draws);
        const double radius =
            grid == Family::random ? 0.1 + 4 * draws.unit() : 0.5 + draws.below(8) / 2.0;
        scene.list.items.push_back({FillRing{centre, radius}, {shade, 1 - shade, 0, 1}});
        integrals.add_disc(centre, radius, i);
        continue;
      }
      const auto pieces =
          kind == 0 ? std::vector<std::vector<Vec2>>{convex(grid, draws)} : stroke(draws);
      scene.add(pieces, shade);
      for (const auto& piece : pieces) integrals.add_polygon(piece, i);
    }
    const LinearImage picture = render_linear(scene.list, {});
    for (int y = 0; y < kFrame.height; ++y)
      for (int x = 0; x < kFrame.width; ++x) {
        const auto seen = integrals.in_pixel(x, y, items);
        double red = 0;
        for (std::size_t i = 0; i < items; ++i)
          red += static_cast<double>(seen[i]) * static_cast<double>(scene.list.items[i].colour.r);
        const auto at = 3 * static_cast<std::size_t>(y * kFrame.width + x);
        const double error = std::abs(static_cast<double>(picture.pixels[at]) - red);
        ASSERT_LE(error, 1e-6) << "scene " << item << " pixel " << x << ", " << y;
        errors.add(error);
      }
  }
  errors.print("pixels");
  EXPECT_LE(errors.sum / static_cast<double>(errors.count), 1e-8);
}

// In doubles 49 / 49 is below 1: in row 8 the edge from (0, -41) to (2, 57) comes into column 0 and
// leaves it at once. The pixel drawn before it has another light on its left. Found by a golden picture.
TEST(JointCoverage, AnEdgeThatPassesByACornerOfAPixelLeavesItAsItIs) {
  Overlapping scene;
  scene.add({{{0, -41}, {2, 57}, {-90, 57}}}, 0.5F);
  scene.add({{{0.5, 8.25}, {0.75, 8.25}, {0.75, 8.75}, {0.5, 8.75}}}, 1);
  scene.add({{{5.25, 7.25}, {6, 7.25}, {6, 7.75}, {5.25, 7.75}}}, 0.25F);
  scene.add({{{5.5, 7.5}, {6, 7.5}, {6, 7.75}, {5.5, 7.75}}}, 0.75F);
  const LinearImage picture = render_linear(scene.list, {});
  EXPECT_EQ(picture.pixels[3 * 8 * 9], 0.5F * 0.875F + 0.125F);
}

TEST(JointCoverage, ShapesThatAbutShowNoSeam) {
  const LinearColour white{1, 1, 1, 1};
  for (std::uint64_t item = 0; item < 50; ++item) {
    Draws draws(19, item);
    const Vec2 a(9 * draws.unit(), 0), b(9 * draws.unit(), 9);
    const DrawList halves = on_black(
        {{ring_path({{0, 0}, a, b, {0, 9}}), white}, {ring_path({a, {9, 0}, {9, 9}, b}), white}});
    const DrawList whole = on_black({{ring_path({{0, 0}, {9, 0}, {9, 9}, {0, 9}}), white}});
    EXPECT_LE(largest_difference(halves, whole), 1e-6) << item;
  }
  const double quarter = 0.5 * std::numbers::pi;
  const auto half_disc = [&](double from) {
    return DrawItem{FillArcs{{{{{4.3, 4.6}, {3.7, 0.4}, {-0.4, 3.7}, from, 2 * quarter}}, true}},
                    white};
  };
  EXPECT_LE(largest_difference(
                on_black({half_disc(0.3), half_disc(0.3 + 2 * quarter)}),
                on_black({{FillArcs{{{{{4.3, 4.6}, {3.7, 0.4}, {-0.4, 3.7}}}, true}}, white}})),
            1e-6);
}

TEST(JointCoverage, WhatLiesTwiceOnItselfIsThereOnce) {
  const DrawItem disc{FillRing{{4.4, 4.7}, 3.3}, {0.3F, 0.9F, 0.1F, 1}};
  const DrawItem below{FillRing{{4.4, 4.7}, 3.3}, {1, 0, 0, 1}};
  EXPECT_EQ(largest_difference(on_black({below, disc}), on_black({disc})), 0);
}

// Veils do not depend on how a shape under them is cut.
TEST(JointCoverage, VeilsOverShapesThatAbutShowNoSeam) {
  const LinearColour red{1, 0, 0, 1}, veil{0, 0, 1, 0.5F};
  const DrawItem over{FillRing{{4, 4}, 3.5}, veil};
  const DrawList halves = on_black({{ring_path({{0, 0}, {4.3, 0}, {5.1, 9}, {0, 9}}), red},
                                    {ring_path({{4.3, 0}, {9, 0}, {9, 9}, {5.1, 9}}), red},
                                    over});
  const DrawList whole = on_black({{ring_path({{0, 0}, {9, 0}, {9, 9}, {0, 9}}), red}, over});
  EXPECT_LE(largest_difference(halves, whole), 1e-6);
}

// Two circles that cross: by rays, which share no areas, crossings or order with it.
TEST(JointCoverage, CurvesThatCrossAgreeWithRays) {
  double mean = 0;
  for (std::uint64_t item = 0; item < 40; ++item) {
    Draws draws(23, item);
    std::vector<DrawItem> items;
    for (int i = 0; i < 4; ++i) {
      const double r = 0.3 + 3 * draws.unit();
      items.push_back({FillRing{{9 * draws.unit(), 9 * draws.unit()}, r, 0.7 * r},
                       {static_cast<float>(draws.unit()), 0.5F, 1, i % 2 ? 1.0F : 0.5F}});
    }
    DrawList area = on_black(items), rays = on_black(items, 9, Coverage::rows);
    rays.rows = 64;
    EXPECT_LE(largest_difference(area, rays), 0.01) << item;
    mean += largest_difference(area, rays) / 40;
  }
  EXPECT_LE(mean, 0.003);
}

// An edge from (0, 0) to (4, 4 / 3) by 2 rays a row: exact along each.
TEST(RowCoverage, IsExactAlongEachRay) {
  DrawList list{4, 1, {0, 0, 0, 1}, Coverage::rows, {}};
  list.rows = 2;
  list.items.push_back({ring_path({{0, 0}, {4, 2}, {0, 2}}), {1, 1, 1, 1}});
  const LinearImage picture = render_linear(list, {});
  // x < 2 y at y = 1/4 and 3/4: 0.5 and 1.5 of the row.
  EXPECT_EQ(picture.pixels[0], 0.75F);
  EXPECT_EQ(picture.pixels[3], 0.25F);
  EXPECT_EQ(picture.pixels[6], 0.0F);
}

TEST(RowCoverage, OfBoxesOnRaysIsTheirArea) {
  const DrawItem box{ring_path({{1.25, 1.5}, {6.75, 1.5}, {6.75, 7.25}, {1.25, 7.25}}),
                     {1, 1, 1, 1}};
  DrawList rows = on_black({box}, 9, Coverage::rows);
  EXPECT_EQ(largest_difference(rows, on_black({box})), 0);
  rows.rows = 1;
  EXPECT_EQ(largest_difference(rows, on_black({box})), 0.5) << "half covered rows are not seen";
}

TEST(RowCoverage, GoesToAreaWithTheNumberOfRays) {
  std::vector<DrawItem> items{{FillRing{{4.2, 4.9}, 3.1}, {1, 0, 0, 1}},
                              {ring_path({{0.3, 0.2}, {8.1, 4.3}, {2.2, 8.7}}), {0, 1, 0, 0.5F}}};
  double before = 1;
  for (const int rays : {1, 4, 16, 64}) {
    DrawList rows = on_black(items, 9, Coverage::rows);
    rows.rows = rays;
    const double error = largest_difference(rows, on_black(items));
    EXPECT_LT(error, before / 2) << rays;
    before = error;
  }
}

}  // namespace
}  // namespace flatray
