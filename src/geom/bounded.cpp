#include "geom/bounded.h"

#include "geom/error_bounds.h"

namespace flatray {

Bounded operator/(const Bounded& a, const Bounded& b) {
  const double first = a.value_.hi / b.value_.hi;
  const Bounded rest = Bounded(a.value_, 0) - Bounded(b.value_, 0) * Bounded(first);
  const double second = rest.value_.hi / b.value_.hi;
  const DoubleDouble value = two_sum(first, second);
  // |a / b - q| <= (|a - b q| + da + |q| db) / (|b| - db), and a - b q is known.
  const Bounded last = rest - Bounded(b.value_, 0) * Bounded(second);
  const double least = std::fabs(b.value_.hi) * (1 - 0x1p-50) - b.error_;
  if (!(least > 0)) return {value, kInfinity};
  if (a.is_exact_zero()) return a;
  const double known = last.error_ + a.error_ + b.error_;
  if (last.value_.hi == 0 && known == 0) return {value, 0};
  // What underflows here would be divided by `least`: it is added before.
  const double miss = std::fabs(last.value_.hi) * (1 + 0x1p-50) + last.error_ + a.error_ +
                      2 * std::fabs(first) * b.error_ + kUnderflowError;
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

Bounded either_root(const Bounded& a) {
  const double most = std::fabs(a.value_.hi) * (1 + 0x1p-50) + a.error_ + kUnderflowError;
  return {{0, 0}, std::sqrt(most) * kRadiusInflation};
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
