#pragma once
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "geom/primitives/bezier.h"

namespace flatray {

/// About where a polynomial is 0 whose coefficients change their sign once: by Newton's method, and by halves where
/// that leads out of where the sign changes. A guess, which the caller proves; of infinities it may be NaN.
inline double only_root_near(const Bernstein<double>& c) {
  double low = 0, high = 1, s = c.front() / (c.front() - c.back());
  const Bernstein<double> rise = bernstein_derivative(c);
  for (int i = 0; i < 64; ++i) {
    const double here = bernstein_value(c, s), next = s - here / bernstein_value(rise, s);
    const bool is_inside = next > 0 && next < 1;  // there may be another root just outside
    if (is_inside && std::fabs(next - s) <= 0x1p-40) return next;  // off by about its square
    ((here < 0) == (c.front() < 0) ? low : high) = s;
    s = next > low && next < high ? next : 0.5 * (low + high);
  }
  return s;
}

/// The roots in [0, 1] of a polynomial by its Bernstein coefficients, in any arithmetic with bounds.
///
/// Needs   Number as geom/enclosure.h has it; make(double) gives one without error, plain(Number) a double
///         near it.
/// Gives   all of them, ascending, or a doubt: where a sign is open, and at double roots between 0
///         and 1, on which halving never ends.
/// Source  halves of [0, 1] until the signs of the coefficients change once at most (the rule of
///         Descartes); Newton's method for intervals, which proves a root where it leads into itself.
template <class Number, class Make, class Plain>
class BernsteinRoots {
 public:
  struct Found {
    Number s;
    int multiplicity;
    Sign slope;  ///< of the first derivative that is not 0
  };

  /// `steps` of Newton's method: each doubles the digits, from 9 on.
  BernsteinRoots(const Make& make, const Plain& plain, int steps)
      : make_(make), plain_(plain), steps_(steps) {}

  std::optional<std::vector<Found>> of(Bernstein<Number> c) && {
    if (!look_at({std::move(c), 0, 1}, 0)) return std::nullopt;
    return std::move(found_);
  }

 private:
  struct Stretch {
    Bernstein<Number> c;
    double low, high;
  };
  static constexpr int kMostHalvings = 48;

  bool look_at(Stretch part, int halvings) {
    int at_low = 0, at_high = 0;
    if (!divide_ends(part, at_low, at_high)) return false;
    if (at_low > 0 && !add(part.low, at_low, *part.c.front().sign())) return false;
    if (part.c.size() > 1 && !look_between(part, halvings)) return false;
    if (part.high != 1 || at_high == 0) return true;  // of others the next part tells
    const Sign before = *part.c.back().sign();
    return add(part.high, at_high, at_high % 2 == 1 ? -before : before);
  }

  // Divides by s - low and high - s as often as they go into the polynomial.
  bool divide_ends(Stretch& part, int& at_low, int& at_high) const {
    Bernstein<Number>& c = part.c;
    for (;;) {
      const auto first = c.front().sign(), last = c.back().sign();
      if (!first || !last) return false;
      if (c.size() == 1) return *first != Sign::zero;
      const auto n = static_cast<double>(c.size() - 1);
      if (*first == Sign::zero) {
        ++at_low;
        c.pop_front();
        for (std::size_t k = 0; k < c.size(); ++k)
          c[k] = c[k] * make_(n / static_cast<double>(k + 1));
      } else if (*last == Sign::zero) {
        ++at_high;
        c.pop_back();
        for (std::size_t k = 0; k < c.size(); ++k)
          c[k] = c[k] * make_(n / (n - static_cast<double>(k)));
      } else {
        return true;
      }
    }
  }

  bool look_between(const Stretch& part, int halvings) {
    int changes = 0;
    bool doubt = false;
    Sign last = *part.c.front().sign();
    for (const Number& c : part.c) {
      const auto sign = c.sign();
      doubt = doubt || !sign;
      if (!sign || *sign == Sign::zero) continue;
      changes += *sign == -last ? 1 : 0;
      last = *sign;
    }
    if (!doubt && changes == 0) return true;
    if (!doubt && changes == 1) return add(part, last);
    if (halvings == kMostHalvings) return false;
    auto parts = halves(part.c, make_(0.5));
    const double middle = 0.5 * (part.low + part.high);
    return look_at({std::move(parts[0]), part.low, middle}, halvings + 1) &&
           look_at({std::move(parts[1]), middle, part.high}, halvings + 1);
  }

  bool add(double s, int multiplicity, Sign slope) {
    if (multiplicity > 1 && s != 0 && s != 1) return false;
    found_.push_back({make_(s), multiplicity, slope});
    return true;
  }
  bool add(const Stretch& part, Sign slope) {
    auto within = root_within(part.c);
    if (!within) return false;
    found_.push_back({make_(part.low) + make_(part.high - part.low) * *within, 1, slope});
    return true;
  }

  // The only root between 0 and 1.
  std::optional<Number> root_within(const Bernstein<Number>& c) const {
    Bernstein<double> plain;
    for (const Number& each : c) plain.push_back(plain_(each));
    const double near = only_root_near(plain);
    const Bernstein<Number> slope = bernstein_derivative(c);
    for (const double reach : {0x1p-30, 0x1p-37, 0x1p-44, 0x1p-51}) {
      if (!(near > reach && near < 1 - reach)) continue;
      const Number middle = make_(near), around = either_root(make_(2 * reach * reach));
      Number root = newton(c, slope, middle, middle + around);
      if ((root - make_(near - reach)).sign() != Sign::positive ||
          (make_(near + reach) - root).sign() != Sign::positive)
        continue;
      for (int step = 1; step < steps_; ++step) root = newton(c, slope, root.middle(), root);
      return root;
    }
    return std::nullopt;
  }
  Number newton(const Bernstein<Number>& c, const Bernstein<Number>& slope, const Number& middle,
                const Number& around) const {
    return middle - bernstein_value(c, middle) / bernstein_value(slope, around);
  }
  const Make& make_;
  const Plain& plain_;
  int steps_;
  std::vector<Found> found_;
};

/// Names the roots of a line and a Bezier curve, told in the order of s, by how they cross.
class RootNames {
 public:
  Root next(int multiplicity, Sign slope) {
    if (multiplicity % 2 == 0) return Root::both;
    if (slope == Sign::positive) return std::exchange(entered_, true) ? Root::third : Root::first;
    return std::exchange(left_, true) ? Root::fourth : Root::second;
  }

 private:
  bool entered_ = false, left_ = false;
};

template <class Number, class Make, class Plain>
auto bernstein_roots(const Make& make, const Plain& plain, Bernstein<Number> c, int steps) {
  return BernsteinRoots<Number, Make, Plain>(make, plain, steps).of(std::move(c));
}

}  // namespace flatray
