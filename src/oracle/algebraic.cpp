#include "oracle/algebraic.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flatray::oracle {
namespace {

void trim(Polynomial& p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
}

Rational at(const Polynomial& p, const Rational& x) {
  Rational sum;
  for (std::size_t i = p.size(); i-- > 0;) sum = sum * x + p[i];
  return sum;
}

// Halving an interval decides most questions within so many steps, or in parts no smaller than this share of it; what
// is left goes to common divisors and Sturm's chains.
constexpr int kHalved = 32;
constexpr double kLeastPart = 0x1p-4;

struct Interval {
  Rational low, high;
  // Of all its numbers; zero where they differ.
  Sign sign() const { return low.sign() == high.sign() ? low.sign() : Sign::zero; }
};

// An end of the products of two intervals: the lower one for way < 0.
Rational end_of_products(const Interval& a, const Interval& b, int way) {
  const auto farther = [way](const Rational& x, const Rational& y) {
    return (way < 0) == (x < y) ? x : y;
  };
  if (b.low < 0)
    return farther(farther(a.low * b.low, a.low * b.high),
                   farther(a.high * b.low, a.high * b.high));
  const Rational& end = way < 0 ? a.low : a.high;
  return end * ((way < 0) == (end < 0) ? b.high : b.low);
}

// Of the values of a polynomial on an interval, by Horner's rule.
Interval range_of(const Polynomial& p, const Interval& x) {
  Interval sum;
  for (std::size_t i = p.size(); i-- > 0;)
    sum = {end_of_products(sum, x, -1) + p[i], end_of_products(sum, x, 1) + p[i]};
  return sum;
}

Polynomial product(const Polynomial& p, const Polynomial& q) {
  Polynomial all(p.empty() || q.empty() ? 0 : p.size() + q.size() - 1);
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t k = 0; k < q.size(); ++k) all[i + k] += p[i] * q[k];
  return all;
}

struct Division {
  Polynomial quotient, rest;
};
Division divided(Polynomial p, const Polynomial& by) {
  Division found{Polynomial(p.size() >= by.size() ? p.size() - by.size() + 1 : 0), {}};
  for (std::size_t i = found.quotient.size(); i-- > 0;) {
    found.quotient[i] = p.back() / by.back();
    for (std::size_t k = 0; k < by.size(); ++k) p[i + k] -= found.quotient[i] * by[k];
    p.pop_back();
  }
  found.rest = std::move(p);
  trim(found.rest);
  return found;
}

// Roots in (low, high].
int roots_between(const Polynomial& p, const Rational& low, const Rational& high) {
  std::vector<Polynomial> chain{p, derivative(p)};
  while (chain.back().size() > 1) {
    Polynomial rest = divided(chain.end()[-2], chain.back()).rest;
    for (Rational& c : rest) c = -c;
    chain.push_back(std::move(rest));
  }
  const auto changes = [&](const Rational& x) {
    int count = 0;
    Sign last = Sign::zero;
    for (const Polynomial& each : chain) {
      const Sign sign = at(each, x).sign();
      if (sign == Sign::zero) continue;
      count += sign == -last ? 1 : 0;
      last = sign;
    }
    return count;
  };
  return changes(low) - changes(high);
}

int roots_in(const Polynomial& p, const Rational& low, const Rational& high) {
  return p.size() > 1 ? roots_between(p, low, high) + (at(p, low) == 0 ? 1 : 0) : 0;
}

Polynomial without_double_roots(const Polynomial& p) {
  return divided(p, common_divisor(p, derivative(p))).quotient;
}

// The polynomial whose roots are the values of q at those of p: Newton's identities lead from the
// coefficients of one to sums of powers of its roots, and back for the other.
Polynomial of_values(const Polynomial& p, const Polynomial& q) {
  const std::size_t n = p.size() - 1;
  std::vector<Rational> sums{static_cast<double>(n)}, values{static_cast<double>(n)};
  for (std::size_t k = 1; k <= n; ++k) {
    Rational sum = Rational(static_cast<double>(k)) * p[n - k];
    for (std::size_t i = 1; i < k; ++i) sum += p[n - i] * sums[k - i];
    sums.push_back(-sum / p[n]);
  }
  Polynomial power{1};
  for (std::size_t k = 1; k <= n; ++k) {
    power = divided(product(power, q), p).rest;
    Rational sum;
    for (std::size_t i = 0; i < power.size(); ++i) sum += power[i] * sums[i];
    values.push_back(std::move(sum));
  }
  Polynomial found(n + 1);
  found[n] = 1;
  for (std::size_t k = 1; k <= n; ++k) {
    Rational sum = values[k];
    for (std::size_t i = 1; i < k; ++i) sum += found[n - i] * values[k - i];
    found[n - k] = -sum / static_cast<double>(k);
  }
  return found;
}

Polynomial polynomial_of(const Surd& x) {
  if (x.s == 0 || x.q == 0) return {-x.p, 1};
  return {x.p * x.p - x.q, -x.p * 2, 1};
}

}  // namespace

Polynomial derivative(const Polynomial& p) {
  Polynomial slope;
  for (std::size_t i = 1; i < p.size(); ++i) slope.push_back(p[i] * static_cast<double>(i));
  return slope;
}

Polynomial common_divisor(Polynomial p, Polynomial q) {
  trim(p), trim(q);
  while (!q.empty()) {
    const Rational first = q.back();
    for (Rational& c : q) c /= first;
    p = std::exchange(q, divided(std::move(p), q).rest);
  }
  return p;
}

struct Algebraic::Value {
  Algebraic of;
  Polynomial polynomial;
};

Algebraic::Algebraic(Polynomial p, Rational low, Rational high)
    : p_(std::move(p)), low_(std::move(low)), high_(std::move(high)) {
  if (p_.size() == 2) low_ = high_ = -p_[0] / p_[1];
  settle();
}

Algebraic::Algebraic(const Surd& surd)
    : Algebraic(polynomial_of(surd), surd.p - (surd.s < 0 ? surd.q + 1 : 0),
                surd.p + (surd.s > 0 ? surd.q + 1 : 0)) {
  const double t = surd.nearest();
  if (low_ == high_ || !std::isfinite(t)) return;
  const Rational low = middle_to(t, -kInfinity), high = middle_to(t, kInfinity);
  if (at(p_, low).sign() == at_low_ && at(p_, high).sign() == -at_low_) low_ = low, high_ = high;
}

Algebraic::Algebraic(std::shared_ptr<const Value> value) : value_(std::move(value)) {
  take_range();
}

void Algebraic::take_range() const {
  Interval range = range_of(value_->polynomial, {value_->of.low_, value_->of.high_});
  low_ = std::move(range.low), high_ = std::move(range.high);
}

void Algebraic::settle() const {
  if (at(p_, high_) == 0) low_ = high_;
  at_low_ = at(p_, low_).sign();
  if (at_low_ == Sign::zero) high_ = low_;
}

std::vector<Algebraic> Algebraic::roots(const Polynomial& p, const Rational& low,
                                        const Rational& high) {
  Polynomial given = p;
  trim(given);
  const Polynomial slope = derivative(given);
  const Rational least = (high - low) * kLeastPart;  // of parts that signs of values tell about
  Polynomial simple;
  std::vector<Algebraic> found;
  if (at(given, low) == 0) found.push_back(Algebraic({-low, 1}, low, low));
  std::vector<Interval> parts{{low, high}};  // without their lower ends
  while (!parts.empty()) {
    const Interval part = std::move(parts.back());
    parts.pop_back();
    if (range_of(given, part).sign() != Sign::zero) continue;
    const bool rises_or_falls = range_of(slope, part).sign() != Sign::zero;
    if (rises_or_falls) {
      const Sign first = at(given, part.low).sign();
      if (first != Sign::zero && at(given, part.high).sign() != first)
        found.push_back(Algebraic(given, part.low, part.high));
      continue;
    }
    if (part.high - part.low <= least) {
      if (simple.empty()) simple = without_double_roots(given);
      const int count = roots_between(simple, part.low, part.high);
      if (count == 0) continue;
      // The root that `part` leaves out, if it is one, is no end of an interval that holds another.
      if (count == 1 && at(simple, part.low) != 0) {
        found.push_back(Algebraic(simple, part.low, part.high));
        continue;
      }
    }
    const Rational middle = (part.low + part.high) / 2;
    parts.push_back({middle, part.high});
    parts.push_back({part.low, middle});
  }
  return found;
}

void Algebraic::halve() const {
  if (p_.empty()) {
    value_->of.halve();
    take_range();
    return;
  }
  const Rational middle = (low_ + high_) / 2;
  const Sign sign = at(p_, middle).sign();
  if (sign == Sign::zero)
    low_ = high_ = middle;
  else
    (sign == at_low_ ? low_ : high_) = middle;
}

const Polynomial& Algebraic::polynomial() const {
  if (p_.empty()) {
    Polynomial simple =
        without_double_roots(of_values(value_->of.polynomial(), value_->polynomial));
    while (roots_in(simple, low_, high_) != 1) halve();
    p_ = std::move(simple);
    settle();
  }
  return p_;
}

Sign Algebraic::sign_of(const Polynomial& q) const {
  for (int halved = 0;; ++halved, halve()) {
    const Interval range = range_of(q, {low_, high_});
    if (range.low.sign() == range.high.sign()) return range.low.sign();
    if (halved == kHalved && roots_in(common_divisor(polynomial(), q), low_, high_) > 0)
      return Sign::zero;
  }
}

Algebraic Algebraic::value_of(const Polynomial& q) const {
  if (low_ == high_) return Algebraic(Surd{at(q, low_), 0, 0});
  return Algebraic(std::make_shared<const Value>(Value{*this, q}));
}

std::strong_ordering Algebraic::operator<=>(const Algebraic& b) const {
  for (int halved = 0;; ++halved, halve(), b.halve()) {
    if (high_ < b.low_) return std::strong_ordering::less;
    if (low_ > b.high_) return std::strong_ordering::greater;
    if (halved != kHalved) continue;
    const Polynomial common = common_divisor(polynomial(), b.polynomial());
    const Rational low = std::max(low_, b.low_), high = std::min(high_, b.high_);
    if (low <= high && roots_in(common, low, high) > 0) return std::strong_ordering::equal;
  }
}

double Algebraic::nearest() const {
  if (sign() == Sign::zero) return 0;
  while (std::nextafter(low_.nearest(), kInfinity) < high_.nearest()) halve();
  const double low = low_.nearest(), high = high_.nearest();
  const auto order = [this](const Rational& x) { return static_cast<int>(sign_of({-x, 1})) <=> 0; };
  const Rational middle = middle_to(low, kInfinity);
  const auto side = low == high ? std::strong_ordering::less : order(middle);
  const double t = side == 0 ? middle.nearest() : side < 0 ? low : high;
  check_nearest(t, order);
  return t;
}

}  // namespace flatray::oracle
