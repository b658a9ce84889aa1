#pragma once
#include <cmath>
#include <limits>
#include <optional>

#include "geom/error_bounds.h"
#include "geom/error_free.h"
#include "geom/predicates.h"

namespace flatray {

#if defined(__x86_64__)
template <class Work>
[[gnu::target("fma"), gnu::flatten]] void work_fused(const Work& work) {
  work();
}
inline bool has_fused() { return __builtin_cpu_supports("fma"); }
#else
template <class Work>
void work_fused(const Work& work) {
  work();
}
constexpr bool has_fused() { return true; }
#endif

/// Does `work`, all of it inlined, with the machine's fused multiplication where it has one; the
/// bits are the same.
template <class Work>
void with_fused(const Work& work) {
  has_fused() ? work_fused(work) : work();
}

/// A real number known to lie within `error` of hi + lo: what is tried before Bounded. It forgets
/// what is exact, so that a sign of 0 is always in doubt, and has nothing to call, so that a formula
/// becomes one run of instructions.
///
/// Gives   the same operators; certain answers only. Overflow makes the error infinite or NaN,
///         underflow is in it.
/// Error   of each operation: kDoubleDoubleError of what goes in or comes out, what the operands are
///         off by, and kUnderflowError. The error is itself rounded, for which kQuickSlack stands
///         in up to 2^30 operations.
class Quick {
 public:
  Quick(double exact) : Quick(exact, 0, 0) {}

  static Quick difference(double a, double b) {
    const DoubleDouble d = two_sum(a, -b);
    return {d.hi, d.lo, 0};
  }
  static Quick product(double a, double b) {
    const DoubleDouble p = two_product(a, b);
    return {p.hi, p.lo, kUnderflowError};
  }

  Quick operator-() const { return {-hi_, -lo_, error_}; }
  friend Quick operator+(const Quick& a, const Quick& b) {
    const DoubleDouble high = two_sum(a.hi_, b.hi_);
    const DoubleDouble sum = two_sum(high.hi, high.lo + (a.lo_ + b.lo_));
    return {sum.hi, sum.lo, a.error_ + b.error_ + kDoubleDoubleError * (a.size() + b.size())};
  }
  friend Quick operator-(const Quick& a, const Quick& b) { return a + -b; }
  friend Quick operator*(const Quick& a, const Quick& b) {
    const DoubleDouble high = two_product(a.hi_, b.hi_);
    const DoubleDouble product = two_sum(high.hi, high.lo + (a.hi_ * b.lo_ + a.lo_ * b.hi_));
    const double from_operands = (a.size() + a.error_) * b.error_ + b.size() * a.error_;
    return {product.hi, product.lo,
            from_operands + kDoubleDoubleError * std::fabs(high.hi) + kUnderflowError};
  }
  friend Quick operator*(const Quick& a, double b) {
    const DoubleDouble high = two_product(a.hi_, b);
    const DoubleDouble product = two_sum(high.hi, high.lo + a.lo_ * b);
    return {product.hi, product.lo,
            a.error_ * std::fabs(b) + kDoubleDoubleError * std::fabs(high.hi) + kUnderflowError};
  }
  friend Quick operator/(const Quick& a, const Quick& b) {
    const double first = a.hi_ / b.hi_;
    const DoubleDouble back = two_product(first, b.hi_);
    const double rest = ((a.hi_ - back.hi) - back.lo) + (a.lo_ - first * b.lo_);
    const DoubleDouble value = two_sum(first, rest / b.hi_);
    // |a / b - q| = |a - b q| / |b|: the errors of a and b, what rounding `rest` loses, and underflow
    // in `back` and `first * b.lo`.
    const double least = b.size() * (1 - 0x1p-50) - b.error();
    const double miss = a.error_ + std::fabs(first) * 2 * b.error_ +
                        kDoubleDoubleError * (a.size() + std::fabs(back.hi)) + kUnderflowError;
    return {value.hi, value.lo, least > 0 ? miss / least + kUnderflowError : kUnknown};
  }
  /// Root of a number that is certain to be positive; else an unknown.
  friend Quick square_root(const Quick& a) {
    const double first = std::sqrt(a.hi_);
    const DoubleDouble back = two_product(first, first);
    const double rest = ((a.hi_ - back.hi) - back.lo) + a.lo_;
    const DoubleDouble value = two_sum(first, rest / (2 * first));
    // |sqrt(a) - r| <= |a - r^2| / r, and r^2 leaves out the square of the second term.
    const double miss = a.error_ + kDoubleDoubleError * a.size() + kUnderflowError;
    const bool positive = a.hi_ > 0 && a.is_sign_known();
    return {value.hi, value.lo,
            positive ? miss / (first * (1 - 0x1p-50)) + kUnderflowError : kUnknown};
  }

  /// The sign, where the error leaves no doubt.
  std::optional<Sign> sign() const {
    return is_sign_known() ? std::optional(sign_of(hi_)) : std::nullopt;
  }
  /// The nearest double, where the error leaves no doubt and it is normal.
  std::optional<double> nearest() const { return is_rounded() ? std::optional(hi_) : std::nullopt; }
  bool is_rounded() const {
    const double reach = error() + 0x1p-52 * std::fabs(lo_) + kUnderflowError;
    return hi_ + (lo_ + reach) == hi_ && hi_ + (lo_ - reach) == hi_ && size() < kUnknown;
  }

  double hi() const { return hi_; }
  double lo() const { return lo_; }
  double error() const { return error_ * kQuickSlack; }
  double size() const { return std::fabs(hi_); }

 private:
  static constexpr double kQuickSlack = 1 + 0x1p-20;
  static constexpr double kUnknown = std::numeric_limits<double>::infinity();

  Quick(double hi, double lo, double error) : hi_(hi), lo_(lo), error_(error) {}
  bool is_sign_known() const { return size() * (1 - 0x1p-50) > error(); }

  double hi_, lo_, error_;
};

}  // namespace flatray
