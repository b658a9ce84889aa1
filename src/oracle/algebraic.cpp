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

struct Interval {
  Rational low, high;
};

// Of the values of a polynomial on an interval, by Horner's rule.
Interval range_of(const Polynomial& p, const Interval& x) {
  Interval sum;
  for (std::size_t i = p.size(); i-- > 0;) {
    const Rational corners[] = {sum.low * x.low, sum.low * x.high, sum.high * x.low,
                                sum.high * x.high};
    const auto [least, most] = std::minmax_element(std::begin(corners), std::end(corners));
    sum = {*least + p[i], *most + p[i]};
  }
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
  return roots_between(p, low, high) + (at(p, low) == 0 ? 1 : 0);
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

Algebraic::Algebraic(Polynomial p, Rational low, Rational high)
    : p_(std::move(p)), low_(std::move(low)), high_(std::move(high)) {
  if (p_.size() == 2) low_ = high_ = -p_[0] / p_[1];
  if (at(p_, low_) == 0) high_ = low_;
  if (at(p_, high_) == 0) low_ = high_;
}

Algebraic::Algebraic(const Surd& surd)
    : Algebraic(surd.s == 0 || surd.q == 0 ? Polynomial{-surd.p, 1}
                                           : Polynomial{surd.p * surd.p - surd.q, -surd.p * 2, 1},
                surd.p - (surd.s < 0 ? surd.q + 1 : 0), surd.p + (surd.s > 0 ? surd.q + 1 : 0)) {}

std::vector<Algebraic> Algebraic::roots(const Polynomial& p, const Rational& low,
                                        const Rational& high) {
  Polynomial given = p;
  trim(given);
  const Polynomial simple = without_double_roots(given);
  std::vector<Algebraic> found;
  if (at(simple, low) == 0) found.push_back(Algebraic(simple, low, low));
  std::vector<Interval> parts{{low, high}};
  while (!parts.empty()) {
    const Interval part = std::move(parts.back());
    parts.pop_back();
    const int count = roots_between(simple, part.low, part.high);
    if (count == 0) continue;
    // The root that `part` leaves out, if it is one, is no end of an interval that holds another.
    const bool alone = count == 1 && at(simple, part.low) != 0;
    if (alone) {
      found.push_back(Algebraic(simple, part.low, part.high));
      continue;
    }
    const Rational middle = (part.low + part.high) / 2;
    parts.push_back({middle, part.high});
    parts.push_back({part.low, middle});
  }
  return found;
}

void Algebraic::halve() const {
  const Rational middle = (low_ + high_) / 2;
  const Sign sign = at(p_, middle).sign();
  if (sign == Sign::zero)
    low_ = high_ = middle;
  else
    (sign == at(p_, low_).sign() ? low_ : high_) = middle;
}

bool Algebraic::is_root_of(const Polynomial& divisor) const {
  return divisor.size() > 1 && roots_in(divisor, low_, high_) > 0;
}

Sign Algebraic::sign_of(const Polynomial& q) const {
  if (is_root_of(common_divisor(p_, q))) return Sign::zero;
  for (;; halve()) {
    const Interval range = range_of(q, {low_, high_});
    if (range.low.sign() == range.high.sign()) return range.low.sign();
  }
}

Algebraic Algebraic::value_of(const Polynomial& q) const {
  const Polynomial simple = without_double_roots(of_values(p_, q));
  for (;; halve()) {
    const Interval range = range_of(q, {low_, high_});
    if (roots_in(simple, range.low, range.high) == 1) return {simple, range.low, range.high};
  }
}

std::strong_ordering Algebraic::operator<=>(const Algebraic& b) const {
  const Rational low = std::max(low_, b.low_), high = std::min(high_, b.high_);
  const Polynomial common = common_divisor(p_, b.p_);
  if (low <= high && common.size() > 1 && roots_in(common, low, high) > 0)
    return std::strong_ordering::equal;
  for (;; halve(), b.halve()) {
    if (high_ < b.low_) return std::strong_ordering::less;
    if (low_ > b.high_) return std::strong_ordering::greater;
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
