// needs: mpfr
// Goal R4: how far an orbit in doubles is off after k bounces, and up to where its walls are right.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/philox.h"
#include "precise/certified_orbit.h"
#include "precise/rooms.h"

namespace flatray {
namespace {

constexpr std::uint64_t kBounces = 60;
constexpr double kMoved = 0x1p-30;  // of a neighbour's start; small beside what it must grow to

double off(const CertifiedOrbit::Bounce& there, const Vec2& point) {
  return (there.point - point).norm();
}

// How near a straight way comes to meeting other walls than it does: by ends and by tangents.
double gap(const Surfaces& walls, const Vec2& from, const Vec2& to) {
  const Vec2 way = (to - from).normalized();
  double least = 1;
  for (const Segment& wall : walls.segments)
    for (const Vec2& end : {wall.a, wall.b})
      least = std::min(least, std::fabs(cross(way, Vec2(end - from))));
  for (const Arc& wall : walls.arcs) {
    const auto [centre, radius] = circle_of(wall.curve);
    least = std::min(least, std::fabs(std::fabs(cross(way, Vec2(centre - from))) - radius));
  }
  return least;
}

struct Told {
  std::uint64_t bounces = 0, right = 0;  // looked at; of them on walls the rule promises
  double worst = 0;                      // error, in parts of the bound
};

// 8 * 2^-52 (k + 1) M 10^loss, the loss being what orbits beside it have grown to.
Told hold_against_rule(const Surfaces& walls, const Ray& start) {
  const Vec2 along = start.direction.normalized(), across(-along.y(), along.x());
  const double most = bounds_of(walls).high.cwiseAbs().maxCoeff();
  const auto exact = certified_orbit(walls, start, kBounces);
  const auto moved =
      certified_orbit(walls, {start.origin + kMoved * across, start.direction}, kBounces);
  const auto turned =
      certified_orbit(walls, {start.origin, along + kMoved / most * across}, kBounces);
  const Orbit plain =
      trace_orbit(walls, std::vector(walls.size(), Material::mirror), start, kBounces);
  Told told;
  double growth = 1, kept = kInfinity;
  Vec2 from = start.origin;
  for (std::size_t k = 0; k < kBounces; ++k) {
    const CertifiedOrbit::Bounce& there = exact->bounces[k];
    for (const auto* beside : {&*moved, &*turned})
      growth = std::max(growth, off(there, beside->bounces[k].point) / kMoved);
    const double bound = 8 * 0x1p-52 * static_cast<double>(k + 1) * most * growth;
    kept = std::min(kept, gap(walls, from, there.point));
    from = there.point;
    ++told.bounces;
    if (growth * kMoved > 0.01) return told;  // neighbours tell no rate any more
    if (bound >= kept) return told;
    EXPECT_EQ(plain.bounces[k].surface, there.surface) << k;
    told.worst = std::max(told.worst, off(there, plain.bounces[k].point) / bound);
    ++told.right;
  }
  return told;
}

void expect_rule(const Surfaces& walls, std::uint64_t least_right) {
  std::uint64_t right = 0;
  for (std::uint32_t i = 0; i < 40; ++i) {
    const double x = unit_double(random_bits(5, Stream::test, 0, i, 0));
    const double y = unit_double(random_bits(5, Stream::test, 0, i, 1));
    const double angle = 6.283 * unit_double(random_bits(5, Stream::test, 0, i, 2));
    const Told told = hold_against_rule(
        walls, {{1.2 + 0.5 * x, 1.2 + 0.5 * y}, {std::cos(angle), std::sin(angle)}});
    EXPECT_LE(told.worst, 1) << i;
    right += told.right;
  }
  EXPECT_GE(right, least_right);  // the rule promises something
}

TEST(OrbitError, StaysBelowTheRuleInAPolygon) {
  expect_rule(room({{0, 0}, {7, -1}, {9, 5}, {4, 9}, {-1, 6}}), 40 * 50);
}

TEST(OrbitError, StaysBelowTheRuleAmongDiscs) {
  Surfaces walls = room({{-2, -2}, {2, -2}, {2, 2}, {-2, 2}});
  walls.add(Circle{{0, 0}, 1});
  expect_rule(walls, 40 * 8);
}

}  // namespace
}  // namespace flatray
