#include "trace/curve_filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "full_counts.h"
#include "geom/primitives/wall.h"
#include "trace/random_rays.h"

namespace flatray {
namespace {

using Verdict = FilteredHit::Verdict;

// Of 1000 rays and a circle, in any unit: what doubles tell is as much, and no less, as in units of 1.
TEST(CurveFilter, TellsAsMuchOfRaysInAnyUnit) {
  for (const double unit : {0x1p-90, 0x1p-30, 1.0, 0x1p30, 0x1p90}) {
    const Arc circle{Circle{{0, 0}, unit}, Arc::Extent::whole, {0, 0}, {0, 0}};
    Draws draws(1);
    int open = 0;
    for (int i = 0; i < 1000; ++i) {
      const Vec2 from = 4 * draws.point() - Vec2(4, 2);
      const Vec2 way = draws.point() - Vec2(0, 0.5);
      const FilteredHit met = filter_curve({unit * from, unit * way}, circle, Root::none);
      open += met.verdict == Verdict::open ? 1 : 0;
      if (met.verdict == Verdict::sure) {
        EXPECT_LE(met.low, met.high);
      }
    }
    EXPECT_LE(open, 5) << unit;
  }
}

// Rays that touch a circle about whole numbers, to the last bit, in any unit.
TEST(CurveFilter, IsNeverSureOfATangent) {
  for (const double unit : {0x1p-90, 0x1p-30, 1.0, 0x1p30, 0x1p90})
    for (int k = 0; k < 100; ++k) {
      const Vec2 centre = Vec2(7 * k + 3, 11 * k - 5), at = centre + Vec2(3, 4);
      const Arc circle{Circle{unit * centre, 5 * unit}, Arc::Extent::whole, {0, 0}, {0, 0}};
      const Vec2 way(4 * (k + 1), -3 * (k + 1));
      const FilteredHit met = filter_curve({unit * (at - way), unit * way}, circle, Root::none);
      EXPECT_EQ(met.verdict, Verdict::open) << k;
    }
}

// What is told of a ray is what the exact meeting says. Gives whether anything is told.
template <class Wall>
bool tells_what_is_true(const Ray& ray, const Wall& wall, Root left) {
  const FilteredHit filtered = filter_curve(ray, wall, left);
  std::vector<WallMeeting> met;
  meet(wall, ray, {left, true, true}, met);
  std::erase_if(met, [](const WallMeeting& one) { return one.time.sign() == Sign::negative; });
  std::ranges::sort(
      met, [](const WallMeeting& a, const WallMeeting& b) { return compare(a.time, b.time) < 0; });
  if (filtered.verdict == Verdict::missed) {
    EXPECT_TRUE(met.empty());
  } else if (!met.empty()) {
    EXPECT_LE(filtered.low, met.front().time.nearest().t);
  }
  if (filtered.verdict != Verdict::sure) return filtered.verdict == Verdict::missed;
  EXPECT_FALSE(met.empty());
  if (met.empty()) return true;
  const WallMeeting& first = met.front();
  EXPECT_EQ(filtered.root, first.root);
  EXPECT_EQ(first.kind, HitClass::through);
  EXPECT_FALSE(first.at_end);
  EXPECT_GE(filtered.high, first.time.nearest().t);
  return true;
}

// Of arcs whose ends lie on their circle, beside it by an ulp, and by a tenth: what is told of rays that have
// left the arc or not is what the exact meeting says, and nearly all is told where ends are close to it.
TEST(CurveFilter, TellsOfPartsOfCurvesWhatIsTrue) {
  Draws draws(2);
  int told = 0, close = 0;
  for (int i = 0; i < 40000; ++i) {
    const auto direction = [&] { return Vec2((2 * draws.point() - Vec2(1, 1)).normalized()); };
    const Vec2 from = direction(), to = direction();
    const double beside[] = {0, 0x1p-52, -0x1p-52, 0.1, -0.1};
    const double off = beside[i % 5];
    const Ellipse curve =
        i % 2 == 0 ? Ellipse(Circle{{0, 0}, 1}) : Ellipse({0, 0}, {2, 1}, {-0.5, 1});
    const Vec2 u = curve.u, v = curve.v;
    const auto place = [&](const Vec2& p) { return Vec2((1 + off) * (p.x() * u + p.y() * v)); };
    const Arc arc{curve, i % 7 == 0 ? Arc::Extent::half : Arc::Extent::between, place(from),
                  place(to)};
    Ray ray{6 * draws.point() - Vec2(3, 3), 2 * draws.point() - Vec2(1, 1)};
    if (i % 11 == 0) ray.direction = arc.from - ray.origin;
    const Root left = i % 3 == 0 ? Root::first : i % 3 == 1 ? Root::second : Root::none;
    const bool tells = tells_what_is_true(ray, arc, left);
    ASSERT_FALSE(HasFailure()) << i;
    if (std::fabs(off) > 0.01 || i % 11 == 0) continue;
    ++close;
    told += tells ? 1 : 0;
  }
  EXPECT_GT(told, 0.999 * close);
}

// Parabolas, cubic curves and loops; rays from beside them, and from a double next to them that have left them; to any
// side, and at their ends and where they cross themselves, of which nothing may be told.
TEST(CurveFilter, TellsOfBezierCurvesWhatIsTrue) {
  Draws draws(3);
  int told = 0, others = 0;
  for (std::uint64_t i = 0; i < times(20000); ++i) {
    const auto point = [&] { return Vec2(4 * draws.point() - Vec2(2, 2)); };
    Bezier curve(point(), point(), point(), point());
    if (i % 3 == 1) curve = Bezier(point(), point(), point());
    if (i % 3 == 2) curve = Bezier(Vec2(-18, 12), Vec2(26, -4), Vec2(-26, -4), Vec2(18, 12));
    const bool leaves = i % 4 == 1;
    const Vec2 origin = leaves ? point_at(curve, draws.unit()) : Vec2(8 * point());
    Ray ray{origin, point()};
    if (i % 11 == 0) ray.direction = curve.end() - origin;
    if (i % 11 == 1) ray.direction = Vec2(0, 3) - origin;
    if (ray.direction == Vec2(0, 0)) continue;
    const bool tells = tells_what_is_true(ray, curve, leaves ? Root::first : Root::none);
    ASSERT_FALSE(HasFailure()) << i;
    if (i % 11 < 2 || leaves) continue;
    ++others;
    told += tells ? 1 : 0;
  }
  EXPECT_GT(told, 0.999 * others);
}

}  // namespace
}  // namespace flatray
