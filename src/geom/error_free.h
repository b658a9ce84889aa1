#pragma once
#include <cmath>

#include "geom/error_bounds.h"

namespace flatray {

/// An unevaluated sum; `lo` is what rounding to `hi` left out, so |lo| <= ulp(hi) / 2.
struct DoubleDouble {
  double hi, lo;
};

/// a + b without error; NaN in `lo` where the sum overflows. Source: Knuth.
inline DoubleDouble two_sum(double a, double b) {
  const double sum = a + b, from_b = sum - a;
  return {sum, (a - (sum - from_b)) + (b - from_b)};
}

/// a * b without error. Needs a product that is 0 by a zero factor, or between 2^-960 and 2^1023 in
/// size.
inline DoubleDouble two_product(double a, double b) {
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

/// Whether it is such a product.
inline bool is_exact_product(double a, double b) {
  const double size = std::fabs(a * b);
  return a == 0 || b == 0 || (size >= kExactProductLeast && size <= kExactProductMost);
}

}  // namespace flatray
