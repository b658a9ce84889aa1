#include "geom/quick_quotient.h"

#include <cmath>
#include <limits>

#include "geom/error_bounds.h"
#include "geom/error_free.h"

namespace flatray {
namespace {

#define FLATRAY_INLINE inline __attribute__((always_inline))

// Between these nothing that underflows is more than 2^-400 of a bound.
constexpr double kLeast = 0x1p-400, kMost = 0x1p400;

struct Point {
  DoubleDouble x, y;
};

FLATRAY_INLINE Point difference(const double* from, const double* to) {
  return {two_sum(to[0], -from[0]), two_sum(to[1], -from[1])};
}

// a b, off by less than 2^-103 of it: the product of the tails, and what rounding the rest loses.
FLATRAY_INLINE DoubleDouble product(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble high = two_product(a.hi, b.hi);
  return {high.hi, high.lo + (a.hi * b.lo + a.lo * b.hi)};
}

struct Determinant {
  DoubleDouble value;
  double size;  // the value is off by less than 2^-101 of it
};

FLATRAY_INLINE Determinant determinant(const Point& a, const Point& b) {
  const DoubleDouble left = product(a.x, b.y), right = product(a.y, b.x);
  const DoubleDouble high = two_sum(left.hi, -right.hi);
  return {two_sum(high.hi, high.lo + (left.lo - right.lo)),
          __builtin_fabs(left.hi) + __builtin_fabs(right.hi)};
}

FLATRAY_INLINE bool is_usual(const Determinant& d) {
  return d.size < kMost && __builtin_fabs(d.value.hi) > kLeast;
}

FLATRAY_INLINE double quotient(const double* a, const double* b, const double* c, const double* d,
                               const double* from, const double* to) {
  const Point along = difference(from, to);
  const Determinant numer = determinant(difference(a, b), along);
  const Determinant denom = determinant(difference(c, d), along);
  if (!is_usual(numer) || !is_usual(denom)) return std::numeric_limits<double>::quiet_NaN();
  const double first = numer.value.hi / denom.value.hi;
  const DoubleDouble back = two_product(first, denom.value.hi);
  const double rest =
      ((numer.value.hi - back.hi) - back.lo) + (numer.value.lo - first * denom.value.lo);
  const double second = rest / denom.value.hi;
  const double t = first + second, tail = second - (t - first);
  // What the determinants are off by, twice; what `rest` and `second` are rounded by, each a few
  // u of `second`, itself a few u of `first`.
  const double error = 0x1p-100 * (numer.size + __builtin_fabs(first) * denom.size) /
                           __builtin_fabs(denom.value.hi) +
                       0x1p-100 * __builtin_fabs(first);
  const bool certain = t + (tail + error) == t && t + (tail - error) == t;
  return certain ? t : std::numeric_limits<double>::quiet_NaN();
}

#if defined(__x86_64__)
[[gnu::target("fma")]] double fused(const double* a, const double* b, const double* c,
                                    const double* d, const double* from, const double* to) {
  return quotient(a, b, c, d, from, to);
}
#endif

}  // namespace

double quick_quotient(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d, const Vec2& from,
                      const Vec2& to) {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("fma"))
    return fused(a.data(), b.data(), c.data(), d.data(), from.data(), to.data());
#endif
  return quotient(a.data(), b.data(), c.data(), d.data(), from.data(), to.data());
}

}  // namespace flatray
