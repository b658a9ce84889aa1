#pragma once
#include <cmath>

#include "geom/error_bounds.h"
#include "geom/error_free.h"

// The arithmetics in which an Enclosure holds its middle. Each tells of its operations on numbers
// without error what they lose: the only place where a rounding is bounded by hand.
namespace flatray {

/// Whether it is 0 as the compiler sees it, as the low part and the error of a double are: what need
/// not be computed then changes no value.
inline bool is_surely_zero(double x) { return __builtin_constant_p(x == 0) && x == 0; }

/// The result of an operation, and a bound of what it lost.
template <class Value>
struct Lossy {
  Value value;
  double lost;  ///< of a quotient a / b what a - b q is, of a root r of a what a - r^2 is
};

/// One double: every operation rounds once.
struct Doubles {
  using Value = double;
  static constexpr bool kKnowsExact = false;

  static Value of(double x) { return x; }
  static double high(Value x) { return x; }
  static Value negative(Value x) { return -x; }
  static Lossy<Value> sum(Value a, Value b) {
    const double value = a + b;
    return {value, kDoubleError * std::fabs(value)};
  }
  static Lossy<Value> product(Value a, Value b) {
    const double value = a * b;
    return {value, kDoubleError * std::fabs(value) + kUnderflowError};
  }
  static Lossy<Value> quotient(Value a, Value b) {
    return {a / b, kDoubleError * std::fabs(a) + kUnderflowError};
  }
  static Lossy<Value> root(Value a) {
    return {std::sqrt(a), 3 * kDoubleError * a + kUnderflowError};
  }
};

/// A sum of two doubles, without branches: a formula becomes one run of instructions.
struct DoubleDoubles {
  using Value = DoubleDouble;
  static constexpr bool kKnowsExact = false;

  static Value of(double x) { return {x, 0}; }
  static double high(const Value& x) { return x.hi; }
  static Value negative(const Value& x) { return {-x.hi, -x.lo}; }
  static Lossy<Value> sum(const Value& a, const Value& b) {
    const DoubleDouble high = two_sum(a.hi, b.hi);
    if (is_surely_zero(a.lo) && is_surely_zero(b.lo))
      return {high, 0 * high.lo};  // of infinity NaN
    return {two_sum(high.hi, high.lo + (a.lo + b.lo)),
            kDoubleDoubleError * (std::fabs(a.hi) + std::fabs(b.hi))};
  }
  static Lossy<Value> product(const Value& a, const Value& b) {
    const DoubleDouble high = two_product(a.hi, b.hi);
    const bool short_a = is_surely_zero(a.lo), short_b = is_surely_zero(b.lo);
    if (short_a && short_b) return {high, kUnderflowError};
    const double low = short_a ? a.hi * b.lo : short_b ? a.lo * b.hi : a.hi * b.lo + a.lo * b.hi;
    return {two_sum(high.hi, high.lo + low),
            kDoubleDoubleError * std::fabs(high.hi) + kUnderflowError};
  }
  static Lossy<Value> quotient(const Value& a, const Value& b) {
    const double first = a.hi / b.hi;
    const DoubleDouble back = two_product(first, b.hi);
    const double rest = ((a.hi - back.hi) - back.lo) + (a.lo - first * b.lo);
    return {two_sum(first, rest / b.hi),
            kDoubleDoubleError * (std::fabs(a.hi) + std::fabs(back.hi)) + kUnderflowError};
  }
  static Lossy<Value> root(const Value& a) {
    const double first = std::sqrt(a.hi);
    const DoubleDouble back = two_product(first, first);
    const double rest = ((a.hi - back.hi) - back.lo) + a.lo;
    return {two_sum(first, rest / (2 * first)), kDoubleDoubleError * a.hi + kUnderflowError};
  }
};

/// A sum of two doubles that knows where nothing is lost: sums of few bits and their products are
/// without error, exact zeros among them, the usual case on grids.
struct SharpDoubleDoubles : DoubleDoubles {
  static constexpr bool kKnowsExact = true;

  static Lossy<Value> sum(const Value& a, const Value& b) {
    const DoubleDouble high = two_sum(a.hi, b.hi), low = two_sum(a.lo, b.lo);
    const DoubleDouble middle = two_sum(high.lo, low.hi), sum = two_sum(high.hi, middle.hi);
    const DoubleDouble tail = two_sum(sum.lo, low.lo);
    const bool exact = middle.lo == 0 && tail.lo == 0;
    return {two_sum(sum.hi, tail.hi),
            exact ? 0 : kDoubleDoubleError * (std::fabs(a.hi) + std::fabs(b.hi)) + kUnderflowError};
  }
  static Lossy<Value> product(const Value& a, const Value& b) {
    Lossy<Value> made = DoubleDoubles::product(a, b);
    if (a.lo == 0 && b.lo == 0 && is_exact_product(a.hi, b.hi)) made.lost = 0;
    return made;
  }
  static Lossy<Value> quotient(const Value& a, const Value& b);
  static Lossy<Value> root(const Value& a);
};

}  // namespace flatray
