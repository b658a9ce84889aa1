#include "trace/curve_filter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "trace/random_rays.h"

namespace flatray {
namespace {

using Verdict = FilteredCurve::Verdict;

// Of 1000 rays and a circle, in any unit: what doubles tell is as much, and no less, as in units of 1.
TEST(CurveFilter, TellsAsMuchOfRaysInAnyUnit) {
  for (const double unit : {0x1p-90, 0x1p-30, 1.0, 0x1p30, 0x1p90}) {
    const Arc circle{Circle{{0, 0}, unit}, Arc::Extent::whole, {0, 0}, {0, 0}};
    Draws draws(1);
    int open = 0;
    for (int i = 0; i < 1000; ++i) {
      const Vec2 from = 4 * draws.point() - Vec2(4, 2);
      const Vec2 way = draws.point() - Vec2(0, 0.5);
      const FilteredCurve met = filter_curve({unit * from, unit * way}, circle, false);
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
      const FilteredCurve met = filter_curve({unit * (at - way), unit * way}, circle, false);
      EXPECT_EQ(met.verdict, Verdict::open) << k;
    }
}

}  // namespace
}  // namespace flatray
