// Flights in a magnetic field across the room: arcs of circles.
#include <gtest/gtest.h>

#include <cmath>

#include "base/philox.h"
#include "full_counts.h"
#include "transport/chambers.h"
#include "transport/field_meeting.h"

namespace flatray {
namespace {

Orbit in_field(const Surfaces& walls, const Ray& start, std::uint64_t bounces, double field) {
  return trace_orbit(walls, all_mirrors(walls), start, bounces, {.field = field});
}

double draw(std::uint64_t item, std::uint32_t which) {
  return unit_double(random_bits(11, Stream::test, 0, item, which));
}

const std::vector<Vec2> kFieldSquare = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

// Between two bounces off a straight wall lies a chord of it, 2 R sin(alpha) long, alpha between the flight
// and the wall, which the mirror keeps.
TEST(FieldOrbit, SkipsAlongAStraightWallInEqualSteps) {
  Surfaces walls;
  walls.add(Segment{{-100, 0}, {100, 0}});
  const double alpha = 0.4, radius = 0.5;
  // Turning left it comes back to the wall below which it circles.
  const Orbit orbit =
      in_field(walls, {{0, 0}, {-std::cos(alpha), std::sin(alpha)}}, 100, 1 / radius);
  ASSERT_EQ(orbit.bounces.size(), 100U);
  double last = 0;
  for (const Bounce& bounce : orbit.bounces) {
    EXPECT_EQ(bounce.point.y(), 0);
    EXPECT_NEAR(bounce.point.x() - last, -2 * radius * std::sin(alpha), 1e-13);
    EXPECT_NEAR(bounce.t, 2 * radius * alpha, 1e-13);
    last = bounce.point.x();
  }
}

// The circle of radius 5 about 0 touches the disc in (3, 4), where it crosses the wall; what joins the end (6, 8)
// to the other circle is crossed there.
TEST(FieldOrbit, PassesByWhatItTouchesInOnePointAndEndsOnAJoint) {
  const Ray start{{5, 0}, {0, 5}};
  const Segment wall{{2, 4}, {4, 4}};
  for (const Circle& touched : {Circle{{6, 8}, 5}, Circle{{1.5, 2}, 2.5}})
    for (const bool wall_first : {true, false}) {
      Surfaces walls;
      if (!wall_first) walls.add(touched);
      walls.add(wall);
      if (wall_first) walls.add(touched);
      const Orbit orbit = in_field(walls, start, 1, 0.2);
      ASSERT_EQ(orbit.bounces.size(), 1U) << touched.radius << wall_first;
      EXPECT_EQ(orbit.bounces[0].surface, wall_first ? 0U : 1U);
      EXPECT_NEAR((orbit.bounces[0].point - Vec2(3, 4)).norm(), 0, 1e-15);
    }
  for (const bool wall_first : {true, false}) {
    Surfaces walls;
    const Arc joined{Circle{{0, 0}, 1}, Arc::Extent::between, {6, 8}, {-1, 0}};
    if (!wall_first) walls.add(joined);
    walls.add(wall);
    if (wall_first) walls.add(joined);
    const Orbit orbit = in_field(walls, start, 1, 0.2);
    EXPECT_EQ(orbit.end, OrbitEnd::corner) << wall_first;
    EXPECT_EQ(orbit.end_point, Vec2(3, 4));
    EXPECT_EQ(orbit.end_surfaces, (std::vector<std::uint32_t>{0, 1}));
  }
}

// Past the end of a lone wall it comes round, and meets the wall from behind where it left it.
TEST(FieldOrbit, ComesRoundToTheWallItLeft) {
  Surfaces walls;
  walls.add(Segment{{-1, 0}, {1, 0}});
  const Orbit orbit = in_field(walls, {{0.5, 0}, {0, 1}}, 2, -1);  // to the right, about (1.5, 0)
  ASSERT_EQ(orbit.bounces.size(), 2U);
  EXPECT_EQ(orbit.bounces[0].point, Vec2(0.5, 0));
  EXPECT_EQ(orbit.bounces[0].normal, Vec2(0, -1));
  EXPECT_NEAR(orbit.bounces[0].t, 2 * 3.141592653589793, 1e-14);
  EXPECT_EQ(orbit.bounces[0].out, Vec2(0, -1));
  EXPECT_EQ(orbit.bounces[1].point, Vec2(0.5, 0));  // about (-1/2, 0), from above
  EXPECT_EQ(orbit.bounces[1].normal, Vec2(0, 1));
}

// Rotation about the common centre keeps the angle at each circle and the steps between bounces.
TEST(FieldOrbit, KeepsTheAngleInACircleAndInAnAnnulus) {
  for (const double inner : {0.0, 0.4}) {
    Surfaces walls;
    walls.add(Circle{{0, 0}, 1});
    if (inner > 0) walls.add(Circle{{0, 0}, inner});
    for (const double field : {0.3, inner > 0 ? -0.5 : -1.7}) {
      const Vec2 direction = inner > 0 ? Vec2(-0.9, 0.2) : Vec2(0.6, 0.8);
      const Orbit orbit = in_field(walls, {{0.7, 0.1}, direction}, 60, field);
      ASSERT_EQ(orbit.bounces.size(), 60U);
      const auto angle = [](const Vec2& v) { return std::atan2(v.y(), v.x()); };
      const std::size_t period = orbit.bounces[1].surface == orbit.bounces[2].surface ? 1 : 2;
      EXPECT_EQ(period, inner > 0 ? 2U : 1U);
      const double step = angle(orbit.bounces[1 + period].point) - angle(orbit.bounces[1].point);
      for (std::size_t i = 1; i + period < orbit.bounces.size(); ++i) {
        const Bounce& a = orbit.bounces[i];
        const Bounce& b = orbit.bounces[i + period];
        EXPECT_EQ(a.surface, b.surface);
        EXPECT_NEAR(a.incidence(), b.incidence(), 1e-12);
        const double more = angle(b.point) - angle(a.point) - step;
        EXPECT_NEAR(std::remainder(more, 2 * 3.141592653589793), 0, 1e-12);
      }
    }
  }
}

TEST(FieldOrbit, CirclesFreelyWhereNoWallIsInReach) {
  const Surfaces walls = ring(kFieldSquare);
  const Orbit free = in_field(walls, {{0.5, 0.25}, {1, 0}}, 9, 4.5);
  EXPECT_EQ(free.end, OrbitEnd::cyclotron);
  EXPECT_TRUE(free.bounces.empty());
  EXPECT_EQ(orbit_lines(free).back().line.b, free.start);
  // A wall touched in one point is passed by; a little farther it is met.
  EXPECT_EQ(in_field(walls, {{0.5, 0.5}, {1, 0}}, 9, 4).end, OrbitEnd::cyclotron);
  EXPECT_EQ(in_field(walls, {{0.5, 0.5 + 0x1p-52}, {1, 0}}, 9, 4).end, OrbitEnd::limit);
}

// About (1/4, 0) through (1/4, 1/4), exactly: an end of both walls.
TEST(FieldOrbit, ACornerMetExactlyEndsIt) {
  Surfaces corner;
  corner.add(Segment{{0.25, 0.25}, {2, 0.25}});
  corner.add(Segment{{0.25, 0.25}, {0.25, 2}});
  const Orbit met = in_field(corner, {{0, 0}, {0, 1}}, 9, -4);
  EXPECT_EQ(met.end, OrbitEnd::corner);
  EXPECT_EQ(met.end_point, Vec2(0.25, 0.25));
  EXPECT_EQ(met.end_surfaces, (std::vector<std::uint32_t>{0, 1}));
}

// As the field goes to 0 the room becomes the straight one.
TEST(FieldOrbit, WeakFieldsMeetTheWallsOfStraightRays) {
  Surfaces walls = ring(kFieldSquare);
  walls.add(Circle{{0.5, 0.5}, 0.2});
  for (std::uint64_t i = 0; i < 20; ++i) {
    const Ray start{{0.2 * draw(i, 0), draw(i, 1)}, {draw(i, 2) - 0.5, draw(i, 3) - 0.5}};
    const Orbit straight = in_mirrors(walls, start, 5);
    const Orbit bent = in_field(walls, start, 5, 1e-13);
    ASSERT_EQ(bent.bounces.size(), straight.bounces.size());
    for (std::size_t k = 0; k < straight.bounces.size(); ++k) {
      EXPECT_EQ(bent.bounces[k].surface, straight.bounces[k].surface) << "ray " << i;
      EXPECT_NEAR((bent.bounces[k].point - straight.bounces[k].point).norm(), 0, 1e-6);
      EXPECT_NEAR(bent.bounces[k].t, straight.bounces[k].t, 1e-5 * straight.bounces[k].t);
    }
  }
}

// An independent program: long doubles, and walls met by the angle flown about the centre.
struct AngleTracer {
  using Real = long double;
  struct Point {
    Real x, y;
  };
  static Point point_of(const Vec2& v) {
    return {static_cast<Real>(v.x()), static_cast<Real>(v.y())};
  }
  static constexpr Real kTurn = 6.283185307179586476925286766559L;
  const Surfaces& walls;
  Real field;
  Point at{}, way{};
  std::uint32_t left = kNoSurface;

  // The first wall of the flight, which it is then reflected at; kNoSurface where there is none.
  std::uint32_t fly() {
    const Real radius = 1 / field;
    const Point centre{at.x - radius * way.y, at.y + radius * way.x};
    Real first = kTurn;
    std::uint32_t wall = kNoSurface;
    const auto offer = [&](std::uint32_t surface, Real x, Real y) {
      const Real from = std::atan2(at.y - centre.y, at.x - centre.x);
      const Real to = std::atan2(y - centre.y, x - centre.x);
      Real angle = std::fmod((field > 0 ? to - from : from - to) + 2 * kTurn, kTurn);
      if (surface == left && (angle < 1e-9L || angle > kTurn - 1e-9L)) return;
      if (angle < first) {
        first = angle;
        wall = surface;
      }
    };
    for (std::uint32_t i = 0; i < walls.size(); ++i) meet(i, centre, std::fabs(radius), offer);
    if (wall == kNoSurface) return wall;
    const Real turn = field > 0 ? first : -first, c = std::cos(turn), s = std::sin(turn);
    const Point from{at.x - centre.x, at.y - centre.y};
    at = {centre.x + c * from.x - s * from.y, centre.y + s * from.x + c * from.y};
    reflect(wall, {c * way.x - s * way.y, s * way.x + c * way.y});
    left = wall;
    return wall;
  }

 private:
  template <class Offer>
  void meet(std::uint32_t i, const Point& centre, Real radius, const Offer& offer) const {
    if (walls.segment_slot(i) != kNoSurface) {
      const Point from = point_of(walls.segment(i).a), to = point_of(walls.segment(i).b);
      const Real ex = to.x - from.x, ey = to.y - from.y;
      const Real gx = from.x - centre.x, gy = from.y - centre.y;
      const Real a = ex * ex + ey * ey, b = ex * gx + ey * gy;
      const Real root = b * b - a * (gx * gx + gy * gy - radius * radius);
      if (root <= 0) return;
      for (const Real sign : {-1.0L, 1.0L}) {
        const Real part = (-b + sign * std::sqrt(root)) / a;
        if (part >= 0 && part <= 1) offer(i, from.x + part * ex, from.y + part * ey);
      }
      return;
    }
    const Ellipse& circle = walls.arc(i).curve;
    const Point middle = point_of(circle.centre);
    const Real dx = middle.x - centre.x, dy = middle.y - centre.y;
    const Real r = point_of(circle.u).x, apart = dx * dx + dy * dy;
    const Real along = (apart + radius * radius - r * r) / (2 * apart);
    const Real root = radius * radius / apart - along * along;
    if (root <= 0) return;
    for (const Real sign : {-1.0L, 1.0L}) {
      const Real across = sign * std::sqrt(root);
      offer(i, centre.x + along * dx - across * dy, centre.y + along * dy + across * dx);
    }
  }
  void reflect(std::uint32_t i, const Point& in) {
    Point normal{};
    if (walls.segment_slot(i) != kNoSurface) {
      const Point from = point_of(walls.segment(i).a), to = point_of(walls.segment(i).b);
      normal = {from.y - to.y, to.x - from.x};
    } else {
      const Point middle = point_of(walls.arc(i).curve.centre);
      normal = {at.x - middle.x, at.y - middle.y};
    }
    const Real share =
        2 * (in.x * normal.x + in.y * normal.y) / (normal.x * normal.x + normal.y * normal.y);
    way = {in.x - share * normal.x, in.y - share * normal.y};
  }
};

TEST(FieldOrbit, MeetsTheWallsAnIndependentProgramMeets) {
  const std::uint64_t rooms = at_full_counts() ? 200 : 40;
  std::uint64_t bounces = 0;
  for (std::uint64_t i = 0; i < rooms; ++i) {
    std::vector<Vec2> corners;
    for (std::uint32_t k = 0; k < 5; ++k) {
      const double angle = (k + 0.6 * draw(i, k)) * 6.283185307179586 / 5;
      corners.emplace_back(2 * std::cos(angle), 2 * std::sin(angle));
    }
    Surfaces walls = ring(corners);
    walls.add(Circle{{0.2 * draw(i, 5), 0.2 * draw(i, 6)}, 0.1 + 0.3 * draw(i, 7)});
    const double angle = 6.283185307179586 * draw(i, 8);
    const double field = (draw(i, 9) - 0.5) * 4;
    const Ray start{{0.9, 0.1 * draw(i, 10)}, {std::cos(angle), std::sin(angle)}};
    const Orbit orbit = in_field(walls, start, 12, field);
    AngleTracer other{walls, static_cast<AngleTracer::Real>(field)};
    other.at = AngleTracer::point_of(start.origin);
    other.way = AngleTracer::point_of(start.direction);
    for (const Bounce& bounce : orbit.bounces) {
      ASSERT_EQ(other.fly(), bounce.surface) << "room " << i;
      const auto off = static_cast<double>(other.at.x) - bounce.point.x();
      if (std::fabs(off) > 1e-7) break;  // rounding parts them
      ++bounces;
    }
    if (orbit.end == OrbitEnd::cyclotron) {
      EXPECT_EQ(other.fly(), kNoSurface) << "room " << i;
    }
  }
  EXPECT_GT(bounces, 6 * rooms);
}

// Nothing leaks, and the speed stays.
TEST(FieldOrbit, StaysInTheRoom) {
  const Surfaces walls = ring(kFieldSquare);
  for (const double field : {0.01, -1.0, 3.0, -40.0}) {
    const Vec2 direction(0.3, -0.4);
    const Orbit orbit = in_field(walls, {{0.5, 0.01}, direction}, 2000, field);
    ASSERT_EQ(orbit.bounces.size(), 2000U) << field;
    for (const Bounce& bounce : orbit.bounces) {
      ASSERT_TRUE(bounce.point.x() >= 0 && bounce.point.x() <= 1);
      ASSERT_TRUE(bounce.point.y() >= 0 && bounce.point.y() <= 1);
      ASSERT_NEAR(bounce.out.norm(), 0.5, 1e-15);
    }
  }
}

TEST(FieldOrbit, IsDrawnAlongItsArcs) {
  const std::vector<Vec2> points = points_between(2, {{1, 0}, {0, 3}}, {0, 0});  // about (1/2, 0)
  ASSERT_EQ(points.size(), 127U);
  for (const Vec2& point : points) EXPECT_NEAR((point - Vec2(0.5, 0)).norm(), 0.5, 1e-14);
  EXPECT_NEAR(points[63].y(), 0.5, 1e-14);
}

}  // namespace
}  // namespace flatray
