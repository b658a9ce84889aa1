#pragma once
#include <optional>
#include <utility>

#include "base/check.h"
#include "geom/exact.h"

namespace flatray {

/// A rational number with the questions of geom/bounded.h and Ball, all of which it answers.
class Certain {
 public:
  explicit Certain(double exact) : value_(exact) {}

  friend Certain operator+(const Certain& a, const Certain& b) { return a.value_ + b.value_; }
  friend Certain operator-(const Certain& a, const Certain& b) { return a.value_ - b.value_; }
  friend Certain operator*(const Certain& a, const Certain& b) { return a.value_ * b.value_; }
  /// Needs b != 0.
  friend Certain operator/(const Certain& a, const Certain& b) { return a.value_ / b.value_; }
  Certain operator-() const { return -value_; }
  /// What only curved walls need, whose orbits leave the rational numbers.
  friend Certain square_root(const Certain&) { unreachable(); }

  std::optional<Sign> sign() const { return value_.sign(); }
  const Rational& value() const { return value_; }

 private:
  Certain(Rational value) : value_(std::move(value)) {}
  Rational value_;
};

}  // namespace flatray
