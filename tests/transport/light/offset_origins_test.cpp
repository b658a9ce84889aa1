// Where light goes on from after a hit: on the right side of its wall, and of all others.
#include "transport/light/offset_origins.h"

#include <gtest/gtest.h>

#include <cmath>

#include "trace/random_rays.h"
#include "trace/tracer.h"
#include "transport/hit_point.h"

namespace flatray {
namespace {

Vec2 point(Draws& draws, double size) { return 2 * size * (draws.point() - Vec2(0.5, 0.5)); }

Ray from_to(const Vec2& from, const Vec2& to) {
  const Vec2 way = to - from;
  return {from, way / std::sqrt(way.squaredNorm())};
}

// Outlines, walls that cross, discs, an ellipse, arcs and Bezier curves that end on others.
Surfaces crowd(Draws& draws, double size) {
  Surfaces walls;
  for (int i = 0; i < 12; ++i) {
    const Vec2 at = point(draws, size), a = point(draws, size / 8), b = point(draws, size / 8);
    walls.add(Segment{at, at + a}), walls.add(Segment{at + a, at + b}),
        walls.add(Segment{at + b, at});
  }
  for (int i = 0; i < 4; ++i) walls.add(Segment{point(draws, size), point(draws, size)});
  for (int i = 0; i < 4; ++i)
    walls.add(Circle{point(draws, size), size / 64 + draws.unit() * size / 4});
  const Vec2 centre = point(draws, size / 2), u = point(draws, size / 2);
  walls.add(
      Arc{Ellipse{centre, u, Vec2(-u.y() / 2, u.x() / 3)}, Arc::Extent::whole, {0, 0}, {0, 0}});
  const Vec2 from = centre + Vec2(size / 4, 0), to = centre + Vec2(0, size / 4);
  walls.add(Arc{Circle{centre, size / 4}, Arc::Extent::between, from, to});
  walls.add(Segment{to, from});
  const Vec2 way = point(draws, size / 8), left(-way.y(), way.x()), start = point(draws, size / 2);
  const double bulge = draws.unit() - 0.5, other = draws.unit() - 0.5;
  walls.add(
      Bezier(start, start + way / 3 + bulge * left, start + way / 1.5 + other * left, start + way));
  walls.add(Segment{start + way, start + way + left});
  walls.add(Bezier(start, start - way / 2 + bulge * left, start - way));
  return walls;
}

double distance(const Surfaces& walls, std::uint32_t surface, const Vec2& point) {
  const auto size = [](double x, double y) { return std::sqrt(x * x + y * y); };
  if (walls.segment_slot(surface) != kNoSurface) {
    const Segment& wall = walls.segment(surface);
    const double ex = wall.b.x() - wall.a.x();
    const double ey = wall.b.y() - wall.a.y();
    const double px = point.x() - wall.a.x();
    const double py = point.y() - wall.a.y();
    const double share = std::clamp((px * ex + py * ey) / (ex * ex + ey * ey), 0.0, 1.0);
    return size(px - share * ex, py - share * ey);
  }
  if (surface == walls.size() - 3 || surface == walls.size() - 1)
    return walls.visit(surface, [&](const auto& wall) {
      if constexpr (std::is_same_v<decltype(wall), const Bezier&>)
        return (point_at(wall, parameter_near(wall, point)) - point).norm();
      return 0.0;
    });
  const Ellipse curve = walls.arc(surface).curve;
  const double x = point.x() - curve.centre.x();
  const double y = point.y() - curve.centre.y();
  if (curve.is_circle()) return std::fabs(size(x, y) - curve.u.x());
  // At least: the share of its radius, times the shorter half-axis.
  const double ux = curve.u.x(), uy = curve.u.y(), vx = curve.v.x(), vy = curve.v.y();
  const double area = ux * vy - uy * vx;
  const double share = size(x * vy - y * vx, ux * y - uy * x) / area;
  return std::fabs(share - 1) * area / size(size(ux, uy), size(vx, vy));
}

Sign side(const Surfaces& walls, std::uint32_t surface, const Vec2& point) {
  return walls.visit(surface, [&](const auto& wall) { return side_of(wall, point); });
}

// Between a hit and what is beside it no wall can be: it is much nearer than any.
TEST(OffsetOrigins, LieBesideTheirWallAndFarFromOthers) {
  std::size_t hits = 0, met = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Draws draws(seed);
    const double size = std::ldexp(1.0, static_cast<int>(seed % 5) * 60 - 120);
    const Surfaces walls = crowd(draws, size);
    const OffsetOrigins origins(walls);
    const auto tracer = accelerate(walls);
    const Bounds all = bounds_of(walls);
    const double most = std::max(all.low.cwiseAbs().maxCoeff(), all.high.cwiseAbs().maxCoeff());
    for (int i = 0; i < 500; ++i) {
      const Ray ray = from_to(point(draws, size), point(draws, size));
      const NearestHit hit = tracer->nearest_of_one(ray, {}, false);
      if (!hit) continue;
      ++hits;
      const auto meeting = origins.meet(ray, hit);
      if (!meeting) continue;
      ++met;
      const Vec2 exact = exact_hit(walls, ray, hit).nearest();
      for (const double way : {1.0, -1.0}) {
        const Vec2 origin = meeting->point + way * origins.distance() * meeting->normal;
        ASSERT_EQ(side(walls, hit.surface, origin), way > 0 ? Sign::positive : Sign::negative)
            << seed;
        ASSERT_LT((origin - exact).cwiseAbs().maxCoeff(), 0x1p-43 * most);
        for (std::uint32_t other = 0; other < walls.size(); ++other) {
          if (other == hit.surface) continue;
          ASSERT_GT(distance(walls, other, origin), 0x1p-37 * most) << seed << ' ' << other;
        }
      }
    }
  }
  EXPECT_GT(hits, 15000U);
  EXPECT_GT(static_cast<double>(met), 0.995 * static_cast<double>(hits));
}

// Of an ellipse the sixth power of its size is looked at.
TEST(OffsetOrigins, OfEllipsesOfAnySizeAreSoundOrNone) {
  for (int exponent = -1000; exponent <= 900; exponent += 10) {
    const double size = std::ldexp(1.0, exponent);
    Surfaces walls;
    walls.add(Arc{Ellipse{{0, 0}, {1.5 * size, 0}, {0, size}}, Arc::Extent::whole, {0, 0}, {0, 0}});
    const Ray ray{{0.1 * size, 0.2 * size}, {0.6, 0.8}};
    const NearestHit hit = accelerate(walls)->nearest_of_one(ray, {}, false);
    ASSERT_TRUE(hit) << exponent;
    const OffsetOrigins origins(walls);
    const auto met = origins.meet(ray, hit);
    EXPECT_TRUE(met || exponent < -100 || exponent > 100) << exponent;
    if (met) {
      EXPECT_NEAR(met->normal.squaredNorm(), 1, 1e-10) << exponent;
    }
  }
}

// A round room about round pillars comes near none of them.
TEST(OffsetOrigins, CurvesInsideCurvesAreFar) {
  Surfaces walls;
  walls.add(Circle{{0, 0}, 10});
  for (int i = 0; i < 40; ++i) walls.add(Circle{{-4.0 + 0.2 * i, 0}, 0.05});
  const Ray ray = from_to({0, 1}, {1, 9});
  EXPECT_TRUE(OffsetOrigins(walls).meet(ray, accelerate(walls)->nearest_of_one(ray, {}, false)));
}

TEST(OffsetOrigins, NothingIsCertainNearAnotherWall) {
  Surfaces walls;
  walls.add(Segment{{-1, 0}, {1, 0}});
  walls.add(Segment{{1, 0}, {1, 1}});              // a corner
  walls.add(Segment{{0, 0x1p-40}, {0, 1}});        // ends just before a wall
  walls.add(Circle{{-0.5, -0.25}, 0.25});          // touches it
  walls.add(Segment{{-0.9, 1}, {-0.8, 0x1p-38}});  // and one not quite
  const OffsetOrigins origins(walls);
  const auto tracer = accelerate(walls);
  for (const double x : {1 - 0x1p-38, 0x1p-38, -0.5, -0.8}) {
    const Ray ray = from_to({x + 0.01, x == -0.5 ? 0.5 : -0.5}, {x, 0});
    const NearestHit hit = tracer->nearest_of_one(ray, {}, false);
    ASSERT_EQ(hit.surface, 0U) << x;
    EXPECT_FALSE(origins.meet(ray, hit)) << x;
  }
  const Ray free = from_to({0.4, -0.5}, {0.3, 0});
  EXPECT_TRUE(origins.meet(free, tracer->nearest_of_one(free, {}, false)));
}

TEST(OffsetOrigins, NorWhereAWeightedCurveCrosses) {
  for (const double weight : {0.25, 3.0}) {
    Surfaces walls;
    walls.add(Segment{{-1, 0}, {1, 0}});
    walls.add(Bezier({-0.1, -0.5}, {0.7, 0}, {0.3, 0.5}, weight));
    const OffsetOrigins origins(walls);
    const auto tracer = accelerate(walls);
    const auto meets = [&](double x) {
      const Ray ray = from_to({x - 0.5, 0.5}, {x, 0});
      const NearestHit hit = tracer->nearest_of_one(ray, {}, false);
      EXPECT_EQ(hit.surface, 0U) << x;
      return origins.meet(ray, hit).has_value();
    };
    Surfaces curve;
    curve.add(walls.beziers[0]);
    const double x = accelerate(curve)->nearest_of_one({{-1, 0}, {1, 0}}).t - 1;
    EXPECT_FALSE(meets(x - 0x1p-38)) << weight;
    EXPECT_TRUE(meets(x - 0.01)) << weight;
    EXPECT_TRUE(meets(-0.5)) << weight;
  }
}

TEST(OffsetOrigins, NorWhereARayGrazesOrComesFromFar) {
  Surfaces walls;
  walls.add(Segment{{-1, 0}, {1, 0}});
  const OffsetOrigins origins(walls);
  const auto tracer = accelerate(walls);
  for (const Ray& ray : {from_to({-0.5, 0x1p-21}, {0, 0}), from_to({0.1, 40}, {0, 0})}) {
    const NearestHit hit = tracer->nearest_of_one(ray, {}, false);
    ASSERT_TRUE(hit);
    EXPECT_FALSE(origins.meet(ray, hit));
  }
}

TEST(OffsetOrigins, NorNearTheEndOfAnArcNorOfCurvesWithoutOne) {
  Surfaces walls;
  walls.add(Arc{Circle{{0, 0}, 1}, Arc::Extent::between, {1, 0}, {0, 1}});
  walls.add(Arc{Circle{{3, 0}, 1}, Arc::Extent::between, {4.5, 0}, {3, 1}});  // joined by a line
  const OffsetOrigins origins(walls);
  const auto tracer = accelerate(walls);
  const auto meets = [&](const Vec2& from, const Vec2& to) {
    const Ray ray = from_to(from, to);
    return origins.meet(ray, tracer->nearest_of_one(ray, {}, false)).has_value();
  };
  EXPECT_TRUE(meets({0.1, 0.1}, {0.7, 0.7}));
  EXPECT_FALSE(meets({0.1, 0.1}, {0x1p-38, 1}));
  EXPECT_FALSE(meets({3.1, 0.1}, {3.7, 0.7}));
}

// A curve that comes back beside itself, one that turns within less than a 2^-20 of all, and one with a cusp
// have none; a parabola, a cubic and arcs of conics that lead along their chords have, but at their ends.
TEST(OffsetOrigins, NorOnBezierCurvesThatTurnBack) {
  const auto meets = [](const Bezier& curve, const Vec2& from, const Vec2& to) {
    Surfaces walls;
    walls.add(curve);
    const Ray ray = from_to(from, to);
    const NearestHit hit = accelerate(walls)->nearest_of_one(ray, {}, false);
    EXPECT_TRUE(hit) << from;
    return OffsetOrigins(walls).meet(ray, hit).has_value();
  };
  EXPECT_TRUE(meets(Bezier({-1, 0}, {0, 1}, {1, 0}), {0.1, -1}, {0.2, 1}));
  EXPECT_TRUE(meets(Bezier({-1, 0}, {0, 1}, {1, -1}, {2, 0}), {0.1, -1}, {0.2, 1}));
  for (const double weight : {0.5, 1.5, 2.5})
    EXPECT_TRUE(meets(Bezier({-1, 0}, {0, 1}, {1, 0}, weight), {0.1, -1}, {0.2, 1})) << weight;
  EXPECT_TRUE(meets(Bezier({-1, 0}, {0, 6}, {1, 0}), {0.1, -1}, {0.2, 1}));  // nearly upright ends
  EXPECT_TRUE(meets(Bezier({-1, 0}, {0, 9}, {1, 0}, 0.25), {0.1, -1}, {0.2, 1}));
  EXPECT_FALSE(meets(Bezier({-1, 0}, {-1, 6}, {0, 6}, {1, 0}), {0.1, -1}, {0.2, 1}));
  EXPECT_FALSE(
      meets(Bezier({-1, 0}, {0, 1}, {1, 0}, 1e7), {0.1, -1}, {0.2, 1}));  // two lines, all but
  EXPECT_FALSE(meets(Bezier({-1, 0}, {0, 1}, {1, 0}), {0, -1}, {1 - 0x1p-38, 0}));
  EXPECT_FALSE(meets(Bezier({0, 0}, {4, 1}, {0, 0.125}), {1, -1}, {1.1, 2}));
  EXPECT_FALSE(meets(Bezier({-1, 0}, {1, 1}, {-1, 1}, {1, 0}), {0.1, -1}, {0.2, 1}));
  EXPECT_FALSE(meets(Bezier({-1, 0}, {0, 0x1p-23}, {0x1p-22, 0x1p-23}, {0x1p-21, 1}), {-0.5, -1},
                     {-0.4, 1}));
}

}  // namespace
}  // namespace flatray
