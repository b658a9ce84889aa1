#include "trace/wall_cells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "full_counts.h"
#include "geom/decide.h"
#include "trace/all_tracers.h"
#include "trace/curve_filter.h"

namespace flatray {
namespace {

// Short and long walls, and curves of all sizes.
Surfaces crowd(Draws& draw, int count, const Vec2& offset) {
  Surfaces walls;
  for (int i = 0; i < count; ++i) {
    const Vec2 at = draw.point() + offset;
    const double size = i % 8 == 0 ? 1 : 0.01;
    if (i % 4 == 3) {
      walls.add(Circle{at, size * draw.unit()});
    } else {
      const Vec2 way = draw.point() - Vec2(0.5, 0.5);
      walls.add(Segment{at, at + size * way});
    }
  }
  return walls;
}

std::vector<std::uint32_t> near(const WallCells& cells, const Vec2& point) {
  return cells.near(point, [](std::uint32_t) { return true; });
}

TEST(WallCells, KnowEveryWallThatComesNearAPoint) {
  for (const double offset : {0.0, 1e3, 1e9}) {
    Draws draw(1);
    const Surfaces walls = crowd(draw, 4000, Vec2(offset, -3 * offset));
    const WallCells cells(walls);
    std::size_t seen = 0;
    for (std::uint32_t i = 0; i < walls.size(); ++i) {
      Vec2 on;
      const double part = draw.unit();
      if (walls.segment_slot(i) != kNoSurface) {
        const Segment& wall = walls.segment(i);
        on = wall.a + part * (wall.b - wall.a);
      } else {
        const Circle circle = circle_of(walls.arc(i).curve);
        on = circle.centre + circle.radius * Vec2(std::cos(6.28 * part), std::sin(6.28 * part));
      }
      const std::vector<std::uint32_t> found = near(cells, on);
      EXPECT_TRUE(std::binary_search(found.begin(), found.end(), i)) << i << " at " << offset;
      EXPECT_TRUE(std::adjacent_find(found.begin(), found.end()) == found.end());
      seen += found.size();
    }
    EXPECT_LT(seen, walls.size() * 200);
  }
}

TEST(WallCells, HoldAFewCellsAWallHoweverLongWallsAre) {
  Draws draw(2);
  Surfaces walls;
  for (int i = 0; i < 20'000; ++i) {
    const Vec2 from = draw.point(), to = draw.point();
    walls.add(Segment{from, to});
  }
  const WallCells cells(walls);
  EXPECT_LT(cells.entries(), 12 * walls.size());
}

TEST(WallCells, OfAFlatSceneAreARow) {
  Surfaces walls;
  for (int i = 0; i < 100; ++i) walls.add(Segment{Vec2(i, 0), Vec2(i + 1, 0)});
  EXPECT_LT(near(WallCells(walls), Vec2(3, 0)).size(), 5U);
}

Vec2 on_curve(const Arc& wall, double angle) {
  return wall.curve.centre + std::cos(angle) * wall.curve.u + std::sin(angle) * wall.curve.v;
}

// Circles, ellipses, parts of less and of more than half a turn, halves and Bezier curves; `place(share)` of each is a
// point of it.
struct Curves {
  Surfaces walls;
  std::vector<std::function<Vec2(double)>> places;

  void add(const Arc& arc, double from, double sweep) {
    walls.add(arc);
    places.push_back([=](double share) { return on_curve(arc, from + share * sweep); });
  }
};
Curves curves_of_all_kinds(Draws& draw, int count, const Vec2& offset) {
  constexpr double kAround = 6.283185307179586;
  Curves curves;
  for (int i = 0; i < count; ++i) {
    const Vec2 at = 10 * draw.point() + offset, u = 0.3 * (draw.point() - Vec2(0.5, 0.5));
    const Ellipse curve(at, u, i % 2 == 0 ? Vec2(-u.y(), u.x()) : 0.3 * draw.point());
    const bool turns_left = u.x() * curve.v.y() > u.y() * curve.v.x();
    Arc arc{curve, Arc::Extent::whole, {0, 0}, {0, 0}};
    const double from = kAround * draw.unit(), sweep = kAround * (i % 3 == 0 ? 0.3 : 0.7);
    if (i % 7 == 0) {
      const Bezier bezier(at, at + u, at + 0.5 * draw.point(), at - u);
      curves.walls.add(bezier);
      curves.places.push_back([=](double share) {
        return Vec2(bernstein_value(coordinates_of(kPlain, bezier, 0), share),
                    bernstein_value(coordinates_of(kPlain, bezier, 1), share));
      });
    } else if (i % 5 == 0) {
      curves.add(arc, 0, kAround);
    } else if (turns_left) {
      arc.extent = Arc::Extent::between;
      arc.from = on_curve(arc, from);
      arc.to = on_curve(arc, from + sweep);
      curves.add(arc, from, sweep);
    } else {
      arc.extent = Arc::Extent::half;
      arc.from = Vec2(-curve.u.y(), curve.u.x());
      const double middle = std::atan2(curve.v.dot(arc.from), curve.u.dot(arc.from));
      curves.add(arc, middle - kAround / 4, kAround / 2);
    }
  }
  return curves;
}

// Towards a point of each, from near and far, and along its tangent there, where no more than the curve is met.
TEST(CellsOfCurves, HoldEveryCurveThatARayMeets) {
  for (const int count : {6, 30, 300})
    for (const double offset : {0.0, 1e6}) {
      Draws draw(3);
      const Curves curves = curves_of_all_kinds(draw, count, Vec2(offset, -2 * offset));
      const auto cells = find_tracer("grid")->build(curves.walls);
      for (std::uint32_t i = 0; i < curves.walls.size(); ++i)
        for (int k = 0; k < static_cast<int>(times(40)); ++k) {
          const double share = k < 2 ? k : draw.unit();
          const Vec2 point = curves.places[i](share), step = curves.places[i](share + 1e-4) - point;
          Vec2 beside = -1e3 * step;
          if (k % 4 != 0) beside = (k % 4) * (draw.point() - Vec2(0.5, 0.5));
          const Ray ray{point - beside, (k % 3 + 0.01) * beside};
          ExactNearest exact(curves.walls, ray, {}, true, true);
          exact.offer_all();
          EXPECT_EQ(cells->all_of_one(ray), exact.hits())
              << i << ", " << k << " of " << count << " at " << offset;
        }
    }
}

// Rays from so far that where they pass a circle is within rounding of touching it.
TEST(CellsOfCurves, HoldCirclesThatRoundingMightPassBy) {
  Draws draw(5);
  Surfaces walls;
  walls.add(Circle{{0.3, -0.7}, 0.15});
  const auto cells = find_tracer("grid")->build(walls);
  int met = 0;
  for (int k = 0; k < 4000; ++k) {
    const double angle = 6.28 * draw.unit(), way = k % 2 == 0 ? -1e8 : 1e8;
    const Vec2 normal(std::cos(angle), std::sin(angle)), along(-normal.y(), normal.x());
    const Ray ray{Vec2(0.3, -0.7) + 0.15 * normal - way * along, way * (draw.unit() + 1) * along};
    ExactNearest exact(walls, ray, {}, true, true);
    exact.offer_all();
    if (exact.hits().empty()) continue;
    EXPECT_EQ(cells->all_of_one(ray), exact.hits());
    ++met;
  }
  EXPECT_GT(met, 1000);
  EXPECT_LT(met, 3000);
}

// Parts that reach through many cells, of ellipses that turn either way, met near their ends and elsewhere: in
// lanes, and by rays alone.
TEST(CellsOfCurves, OfLargePartsGiveTheFirstWall) {
  Draws draw(6);
  Surfaces walls;
  std::vector<std::function<Vec2(double)>> places;
  for (int i = 0; i < 200; ++i) walls.add(Circle{10 * draw.point(), 0.01});
  for (int i = 0; i < 60; ++i) {
    const Vec2 u = 4 * (draw.point() - Vec2(0.5, 0.5)),
               v = (i % 2 == 0 ? 0.6 : -0.6) * Vec2(-u.y(), u.x());
    const Vec2 centre = 10 * draw.point();
    Arc arc{i % 4 == 0 ? Ellipse(Circle{centre, u.norm()}) : Ellipse(centre, u, v),
            Arc::Extent::half,
            u,
            {0, 0}};
    if (i % 4 == 0) arc.from = {1, 0};
    double from = -1.57, sweep = 3.14;
    if (i % 3 > 0) {
      from = 6.28 * draw.unit(), sweep = i % 3 == 1 ? 0.2 + 2 * draw.unit() : 3.3 + 2 * draw.unit();
      const Vec2 first = on_curve(arc, from), last = on_curve(arc, from + sweep);
      arc = {arc.curve, Arc::Extent::between, i % 2 == 0 ? first : last, i % 2 == 0 ? last : first};
    }
    walls.add(arc);
    places.push_back([=](double share) { return on_curve(arc, from + share * sweep); });
  }
  RayBatch rays;
  for (const auto& place : places)
    for (int k = 0; k < 40; ++k) {
      const double share = k % 4 == 0   ? 0.02 * draw.unit()
                           : k % 4 == 1 ? 1 - 0.02 * draw.unit()
                                        : draw.unit();
      const Vec2 way = draw.point() - Vec2(0.5, 0.5);
      rays.add({place(share) - 0.3 * way, way});
    }
  const auto grid = find_tracer("grid")->build(walls);
  std::vector<NearestHit> hits(rays.size()), exact(rays.size());
  grid->nearest(rays, hits);
  find_tracer("exact")->build(walls)->nearest(rays, exact);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    EXPECT_EQ(hits[i], exact[i]) << i;
    EXPECT_EQ(grid->nearest_of_one(rays.ray(i)), exact[i]) << i;
  }
}

// What is met first, and whether anything is, as exact comparisons have it.
void expect_exact(const Surfaces& walls, const Ray& ray, const DepartedSurface& departed = {}) {
  Case c{walls, {}};
  c.rays.add(ray, departed);
  expect_all_tiers_exact(c);
  const bool is_met = static_cast<bool>(exact_hit_of(c, 0));
  const RayBatch rays = many_of(c.rays);
  for (const char* name : {"brute", "grid"}) {
    std::vector<std::uint8_t> met(rays.size());
    find_tracer(name)->build(walls)->any(rays, std::vector<double>(rays.size(), kInfinity), met);
    EXPECT_EQ(met[0] != 0, is_met) << name;
  }
}
Arc part_of(const Circle& circle, const Vec2& from, const Vec2& to) {
  return {circle, Arc::Extent::between, from, to};
}

// Found by a reviewer: they have no cells, beside segments that do.
TEST(CellsOfCurves, CurvesOfNoSizeAndOfAllSizesAreMetBesideSegments) {
  for (const double radius : {0.0, 0x1p-903, 1e280}) {
    Surfaces walls;
    for (int i = 5; i < 35; ++i) walls.add(Segment{{i * 1.0, -1}, {i * 1.0, 1}});
    walls.add(Circle{{0, 0}, radius});
    expect_exact(walls, {{-1, 0}, {1, 0}});
    expect_exact(walls, {{0, 0}, {-1, 0}});
  }
}

// Found by a reviewer: the root is left, what joins the end to the curve is not.
TEST(CellsOfCurves, TheJointBesideTheRootThatIsLeftIsMet) {
  const Vec2 end(-0x1.aa22657537205p-2, 0x1.d18f6ead1b446p-1);
  Surfaces above;
  above.add(part_of({{0, 0}, 1}, {1, 0}, end));
  expect_exact(above, {end, end}, {0, Root::second});
  Surfaces beside;
  beside.add(part_of({{0, 0}, 1}, {1, 0}, {0, 1 + 0x1p-42}));
  expect_exact(beside, {{0x1p-44, 1}, {-1, 1}}, {0, Root::second});
}

// Found by a reviewer: so was what joins an end to the curve, by a ray along a tangent.
TEST(CellsOfCurves, TheJointAheadOfATangentThatIsLeftIsMet) {
  Surfaces walls;
  walls.add(part_of({{0, 0}, 5}, {15, 0}, {0, 15}));
  const Ray tangent{{3, 4}, {4, -3}};
  expect_exact(walls, tangent, {0, Root::both});
  ExactNearest search(walls, tangent, {0, Root::both}, true);
  search.offer_all();
  const NearestHit hit = search.hit();
  EXPECT_TRUE(hit.at_end);
  EXPECT_EQ(hit.root, Root::none);
  EXPECT_DOUBLE_EQ(hit.t, 4.0 / 3);
  EXPECT_EQ(filter_curve(tangent, walls.arcs[0], Root::both).verdict, FilteredHit::Verdict::open);
}

// Found by a reviewer: the end of the curve itself was met twice.
TEST(CellsOfCurves, TheEndOfACurveIsMetOnceBesideItsJoint) {
  Surfaces walls;
  walls.add(part_of({{0, 0}, 1}, {3, 0}, {0, 3}));
  const auto grid = find_tracer("grid")->build(walls);
  const std::vector<NearestHit> all = grid->all_of_one({{-0.5, -0.5}, {1.5, 0.5}}, {}, true);
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].root, Root::second);
  EXPECT_TRUE(all[0].at_end);
  Surfaces round;
  round.add(part_of({{0, 0}, 5}, {5, 0}, {0, 5}));
  EXPECT_FALSE(
      find_tracer("grid")->build(round)->nearest_of_one({{3, 4}, {0, 0}}, {0, Root::both}, true));
}

// Found by a reviewer: rounded into cells, the ends of nearly a whole turn may change their order.
TEST(CellsOfCurves, NearlyAWholeTurnIsMetEverywhere) {
  const Vec2 centre(0x1.7e31f744fc63fp+1, 0x1.f8baf4d1f175ep+0);
  const Vec2 from(0x1.cb556df597127p+0, 0x1.2ba8d07b5099bp+0);
  const Arc nearly =
      part_of({centre, 0x1.6f93fad1df28p+0}, from, {0x1.cb556df597128p+0, 0x1.2ba8d07b5099cp+0});
  for (int i = 0; i < 300; ++i) {
    Surfaces walls;
    walls.add(nearly);
    walls.add(Circle{{-2 - i * 0.025, -9.1}, 1});
    expect_exact(walls, {centre, centre - from});
  }
}

// Found by a reviewer: squares of what a half lies towards are denormal.
TEST(CellsOfCurves, HalvesTowardsWhatIsTinyAreClosed) {
  Draws draw(7);
  Surfaces walls;
  std::vector<Vec2> points;
  for (int i = 0; i < 400; ++i) {
    walls.add(
        Arc{Circle{60 * draw.point(), 1}, Arc::Extent::half, Vec2(2.65e-162, 2.65e-162), {0, 0}});
    const double angle = 0.785398 + (i % 2 == 0 ? 1.56 : -1.56);
    points.push_back(on_curve(walls.arcs.back(), angle));
  }
  for (std::size_t i = 0; i < points.size(); i += 20)
    expect_exact(walls, {points[i] - Vec2(0.01, 0.02), {0.01, 0.02}});
  const WallCells cells(walls);
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const auto found = near(cells, points[i]);
    EXPECT_NE(std::find(found.begin(), found.end(), i), found.end()) << i;
  }
}

// Found by a reviewer: in cells, what these lie towards lost its direction.
TEST(CellsOfCurves, HalvesTowardsWhatIsDenormalKeepTheirDirection) {
  Draws draw(8);
  for (const double unit : {1.0, 0x1p-700, 0x1p300})
    for (const int count : {1, 40}) {
      const int most = unit < 1 ? -360 : -1010;  // its square root, or what doubles hold beside it
      Surfaces walls;
      for (int i = 0; i < count; ++i) {
        const Vec2 centre = unit * draw.point();
        const Vec2 way = 2 * draw.point() - Vec2(1, 1);
        const Vec2 towards = std::ldexp(1.0, most - static_cast<int>(draw.bits() % 20)) * way;
        walls.add(Arc{Circle{centre, 0.2 * unit}, Arc::Extent::half, towards, {0, 0}});
        walls.add(Arc{Circle{centre, 0.1 * unit},
                      Arc::Extent::half,
                      Vec2(draw.whole(-7, 8), 0.5) * 0x1p-1072,
                      {0, 0}});
      }
      for (std::uint64_t i = 0; i < times(30); ++i)
        expect_exact(walls, {unit * draw.point(), unit * (draw.point() - Vec2(0.5, 0.5))});
    }
}

}  // namespace
}  // namespace flatray
