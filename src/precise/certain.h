#pragma once
#include <cmath>
#include <optional>
#include <utility>
#include <variant>

#include "geom/quadratic.h"
#include "precise/ball.h"

namespace flatray {

/// A number a + b sqrt(q) without error as long as its formula has no other root, and a ball from
/// there on: the arithmetic of geom/enclosure.h, with an answer to every question of the former.
class Certain {
 public:
  /// With balls of so many bits.
  Certain(double exact, int bits) : value_(Quadratic(exact)), bits_(bits) {}

  friend Certain operator+(const Certain& a, const Certain& b) {
    return combine(a, b, [](const auto& x, const auto& y) { return x + y; });
  }
  friend Certain operator-(const Certain& a, const Certain& b) {
    return combine(a, b, [](const auto& x, const auto& y) { return x - y; });
  }
  friend Certain operator*(const Certain& a, const Certain& b) {
    return combine(a, b, [](const auto& x, const auto& y) { return x * y; });
  }
  /// Needs b != 0 where it is without error.
  friend Certain operator/(const Certain& a, const Certain& b) {
    return combine(a, b, [](const auto& x, const auto& y) { return x / y; });
  }
  Certain operator-() const {
    return {std::visit([](const auto& x) -> Value { return -x; }, value_), bits_};
  }
  /// Root of a number that is certain to be positive.
  friend Certain square_root(const Certain& a) {
    if (const Rational* square = a.rational()) return {Quadratic::root_of(*square), a.bits_};
    return {square_root(a.ball()), a.bits_};
  }
  friend Certain either_root(const Certain& a) { return {either_root(a.ball()), a.bits_}; }

  std::optional<Sign> sign() const { return exact() ? exact()->sign() : ball().sign(); }
  /// The nearest double, where it is finite and known.
  std::optional<double> nearest() const {
    if (!exact()) return ball().nearest();
    const double value = exact()->nearest();
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
  }

  /// Its double, and what that is off by.
  friend Near near_of(const Certain& x) { return near_of(x.ball()); }

  Certain middle() const { return exact() ? *this : Certain(ball().middle(), bits_); }
  Certain rest() const { return exact() ? Certain(0, bits_) : Certain(ball().rest(), bits_); }

  /// The number where it is without error, and where it is rational too.
  const Quadratic* exact() const { return std::get_if<Quadratic>(&value_); }
  const Rational* rational() const {
    return exact() && exact()->is_rational() ? &exact()->rational() : nullptr;
  }
  Ball ball() const {
    if (!exact()) return std::get<Ball>(value_);
    return exact()->in([this](const Rational& x) { return Ball(x, bits_); });
  }
  Certain blurred() const { return {ball(), bits_}; }
  /// Of the longest number that it is made of.
  std::size_t bits() const { return exact() ? exact()->bits() : static_cast<std::size_t>(bits_); }

 private:
  using Value = std::variant<Quadratic, Ball>;
  Certain(Value value, int bits) : value_(std::move(value)), bits_(bits) {}

  template <class Operation>
  static Certain combine(const Certain& a, const Certain& b, const Operation& of) {
    if (a.exact() && b.exact()) {
      if (a.exact()->shares_root(*b.exact())) return {of(*a.exact(), *b.exact()), a.bits_};
      if (const auto same = b.exact()->by_root_of(*a.exact()))
        return {of(*a.exact(), *same), a.bits_};
    }
    return {of(a.ball(), b.ball()), a.bits_};
  }

  Value value_;
  int bits_;
};

}  // namespace flatray
