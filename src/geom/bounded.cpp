#include "geom/bounded.h"

#include "geom/error_bounds.h"

namespace flatray {
namespace {

// A product of doubles that two_product gives without error.
bool is_exact(double a, double b, double product) {
  const double size = std::fabs(product);
  return a == 0 || b == 0 || (size >= kExactProductLeast && size <= kExactProductMost);
}

}  // namespace

// A result that one operation rounded, in which `size` is the largest that went in or came out.
Bounded Bounded::rounded(DoubleDouble value, double from_operands, double size) {
  const double own = kDoubleDoubleError * size + kUnderflowError;
  return {value, (from_operands + own) * kRadiusInflation};
}

Bounded operator+(const Bounded& a, const Bounded& b) {
  const DoubleDouble high = two_sum(a.value_.hi, b.value_.hi);
  const DoubleDouble low = two_sum(a.value_.lo, b.value_.lo);
  const DoubleDouble middle = two_sum(high.lo, low.hi);
  const DoubleDouble sum = two_sum(high.hi, middle.hi);
  const DoubleDouble tail = two_sum(sum.lo, low.lo);
  const DoubleDouble value = two_sum(sum.hi, tail.hi);
  const double error = a.error_ + b.error_;
  // What the two roundings left out is known, so a sum of few bits stays exact.
  if (middle.lo == 0 && tail.lo == 0) return {value, error * kRadiusInflation};
  return Bounded::rounded(value, error, std::fabs(a.value_.hi) + std::fabs(b.value_.hi));
}

Bounded operator*(const Bounded& a, const Bounded& b) {
  const DoubleDouble high = two_product(a.value_.hi, b.value_.hi);
  const double middle = a.value_.hi * b.value_.lo + a.value_.lo * b.value_.hi;
  const DoubleDouble value = two_sum(high.hi, high.lo + middle);
  const bool short_factors = a.value_.lo == 0 && b.value_.lo == 0;
  if (short_factors && a.error_ == 0 && b.error_ == 0 &&
      is_exact(a.value_.hi, b.value_.hi, high.hi))
    return {value, 0};
  // (a + da)(b + db) - ab, with twice the high parts to stand for the whole values
  const double error = 2 * std::fabs(a.value_.hi) * b.error_ +
                       2 * std::fabs(b.value_.hi) * a.error_ + a.error_ * b.error_;
  return Bounded::rounded(value, error, std::fabs(high.hi));
}

Bounded operator/(const Bounded& a, const Bounded& b) {
  const double first = a.value_.hi / b.value_.hi;
  const Bounded rest = Bounded(a.value_, 0) - Bounded(b.value_, 0) * Bounded(first);
  const double second = rest.value_.hi / b.value_.hi;
  const DoubleDouble value = two_sum(first, second);
  // |a / b - q| <= (|a - b q| + da + |q| db) / (|b| - db), and the rest of the second step is
  // known.
  const Bounded last = rest - Bounded(b.value_, 0) * Bounded(second);
  const double least = std::fabs(b.value_.hi) * (1 - 0x1p-50) - b.error_;
  const double miss = std::fabs(last.value_.hi) * (1 + 0x1p-50) + last.error_ + a.error_ +
                      2 * std::fabs(first) * b.error_;
  if (!(least > 0)) return {value, kInfinity};
  if (miss == 0) return {value, 0};
  return {value, (miss / least + kUnderflowError) * kRadiusInflation};
}

Bounded square_root(const Bounded& a) {
  if (a.value_.hi == 0 && a.error_ == 0) return a;
  if (a.sign() != Sign::positive) return {{0, 0}, kInfinity};
  const double first = std::sqrt(a.value_.hi);
  const Bounded rest = Bounded(a.value_, 0) - Bounded(first) * Bounded(first);
  const double second = rest.value_.hi / (2 * first);
  const DoubleDouble value = two_sum(first, second);
  // |sqrt(a) - r| = |a - r^2| / (sqrt(a) + r) <= |a - r^2| / r, and r is `value`.
  const Bounded last = Bounded(a.value_, 0) - Bounded(value, 0) * Bounded(value, 0);
  const double miss = std::fabs(last.value_.hi) * (1 + 0x1p-50) + last.error_ + a.error_;
  if (miss == 0) return {value, 0};
  return {value, (miss / (first * (1 - 0x1p-50)) + kUnderflowError) * kRadiusInflation};
}

std::optional<Sign> Bounded::sign() const {
  if (error_ == 0 || std::fabs(value_.hi) * (1 - 0x1p-50) > error_) return sign_of(value_.hi);
  return std::nullopt;
}

std::optional<double> Bounded::nearest() const {
  const auto [hi, lo] = value_;
  // The whole range of what the number may be rounds to `hi`; the second term covers rounding lo +-
  // reach.
  const double reach = error_ * kRadiusInflation + 0x1p-52 * std::fabs(lo);
  if (error_ == 0 && lo == 0) return hi + 0.0;  // never -0
  if (hi + (lo + reach) == hi && hi + (lo - reach) == hi && std::fabs(hi) < kInfinity)
    return hi + 0.0;
  return std::nullopt;
}

}  // namespace flatray
