#include "geom/polynomial.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flatray {
namespace {

void trim(Polynomial& p) {
  while (!p.empty() && p.back().sign() == Sign::zero) p.pop_back();
}

// What is left of p by q, and how often q goes into it. Needs   q without leading zeros.
struct Division {
  Polynomial quotient, rest;
};
Division divide(Polynomial p, const Polynomial& q) {
  Polynomial quotient;
  for (; p.size() >= q.size(); p.pop_back()) {
    const Rational times = p.back() / q.back();
    for (std::size_t k = 1; k <= q.size(); ++k) p[p.size() - k] -= times * q[q.size() - k];
    quotient.push_back(times);
  }
  std::reverse(quotient.begin(), quotient.end());
  trim(p);
  return {std::move(quotient), std::move(p)};
}

Polynomial common_divisor(Polynomial p, Polynomial q) {
  for (trim(p), trim(q); !q.empty(); std::swap(p, q)) {
    p = divide(std::move(p), q).rest;
    if (p.empty()) continue;
    const Rational leading = p.back();  // 1 from now on: numbers stay short
    for (Rational& c : p) c /= leading;
  }
  return p;
}

Polynomial without_double_roots(Polynomial p) {
  trim(p);
  return divide(p, common_divisor(p, derivative(p))).quotient;
}

// Sturm's chain of a polynomial without double roots.
class Chain {
 public:
  explicit Chain(const Polynomial& p) : all_{p} {
    for (Polynomial next = derivative(p); !next.empty();) {
      Polynomial rest = divide(all_.back(), next).rest;
      for (Rational& c : rest) c = -c;
      all_.push_back(std::exchange(next, std::move(rest)));
    }
  }
  // Roots in (low, high].
  int roots_between(const Rational& low, const Rational& high) const {
    return sign_changes(low) - sign_changes(high);
  }

 private:
  int sign_changes(const Rational& x) const {
    int changes = 0;
    Sign last = Sign::zero;
    for (const Polynomial& each : all_) {
      const Sign sign = value_at(each, x).sign();
      if (sign == Sign::zero) continue;
      changes += sign == -last ? 1 : 0;
      last = sign;
    }
    return changes;
  }
  std::vector<Polynomial> all_;
};

bool has_root_in(const Polynomial& p, const Rational& low, const Rational& high) {
  return p.size() > 1 &&
         (value_at(p, low).sign() == Sign::zero || Chain(p).roots_between(low, high) > 0);
}

// A double near the only root between two numbers, by bisection in doubles.
double root_near(const Polynomial& p, const Rational& low, const Rational& high) {
  std::vector<double> plain;
  for (const Rational& c : p) plain.push_back(c.nearest());
  const auto value = [&](double x) {
    double sum = 0;
    for (auto c = plain.rbegin(); c != plain.rend(); ++c) sum = sum * x + *c;
    return sum;
  };
  double below = low.nearest(), above = high.nearest();
  const bool rises = value(above) > value(below);
  for (int i = 0; i < 200 && std::nextafter(below, above) < above; ++i) {
    const double middle = 0.5 * (below + above);
    ((value(middle) > 0) == rises ? above : below) = middle;
  }
  return above;
}

struct Interval {
  Rational low, high;
};

Interval range_of(const Polynomial& p, const Interval& x) {
  Interval range{0, 0};
  for (auto c = p.rbegin(); c != p.rend(); ++c) {
    const auto [low, high] = std::minmax(
        {range.low * x.low, range.low * x.high, range.high * x.low, range.high * x.high});
    range = {low + *c, high + *c};
  }
  return range;
}

// By the method of Faddeev and LeVerrier: the characteristic polynomial of multiplying by q modulo p,
// whose roots are the values of q at those of p.
Polynomial polynomial_of_values(const Polynomial& p, const Polynomial& q) {
  const std::size_t n = p.size() - 1;
  std::vector<Polynomial> times;  // column k: q x^k modulo p
  for (Polynomial column = divide(q, p).rest; times.size() < n;) {
    column.resize(n);
    times.push_back(column);
    column.insert(column.begin(), 0);
    column = divide(std::move(column), p).rest;
  }
  Polynomial found(n + 1, 0);
  found[n] = 1;
  std::vector<Polynomial> product(n, Polynomial(n, 0));
  for (std::size_t k = 1; k <= n; ++k) {
    for (std::size_t i = 0; i < n; ++i) product[i][i] += found[n - k + 1];
    std::vector<Polynomial> next(n, Polynomial(n, 0));
    Rational trace = 0;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t row = 0; row < n; ++row)
        for (std::size_t j = 0; j < n; ++j) next[i][row] += product[i][j] * times[j][row];
    for (std::size_t i = 0; i < n; ++i) trace += next[i][i];
    found[n - k] = -trace / static_cast<double>(k);
    product = std::move(next);
  }
  return found;
}

Polynomial product(const Polynomial& p, const Polynomial& q) {
  Polynomial all(p.size() + q.size(), 0);
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t k = 0; k < q.size(); ++k) all[i + k] += p[i] * q[k];
  trim(all);
  return all;
}

// The polynomial whose product with q leaves 1 modulo p, by Euclid's algorithm. Needs   no common root.
Polynomial inverse(Polynomial q, const Polynomial& p) {
  Polynomial last = p, of_last, of_q{1};
  for (q = divide(q, p).rest; q.size() > 1;) {
    Division next = divide(last, q);
    Polynomial of_next = product(next.quotient, of_q);
    of_next.resize(std::max(of_next.size(), of_last.size()), 0);
    for (Rational& c : of_next) c = -c;
    for (std::size_t k = 0; k < of_last.size(); ++k) of_next[k] += of_last[k];
    last = std::exchange(q, std::move(next.rest));
    of_last = std::exchange(of_q, std::move(of_next));
  }
  for (Rational& c : of_q) c /= q[0];
  return of_q;
}

}  // namespace

Polynomial derivative(const Polynomial& p) {
  Polynomial slope;
  for (std::size_t k = 1; k < p.size(); ++k) slope.push_back(p[k] * static_cast<double>(k));
  return slope;
}

RealRoot::RealRoot(Polynomial p, Rational low, Rational high)
    : p_(std::move(p)), low_(std::move(low)), high_(std::move(high)) {
  if (value_at(p_, high_).sign() == Sign::zero) low_ = high_;
  narrow();
}

// To the root itself or some ulps around it, where bisection in doubles leads there.
void RealRoot::narrow() {
  if (low_ == high_) return;
  if (p_.size() == 2) {
    low_ = high_ = -p_[0] / p_[1];
    return;
  }
  const double near = root_near(p_, low_, high_);
  if (!std::isfinite(near)) return;
  const Rational from = near - 0x1p-48 * std::fabs(near), to = near + 0x1p-48 * std::fabs(near);
  if (!(low_ < from && to < high_)) return;
  const Sign before = value_at(p_, from).sign();
  if (value_at<Rational>(p_, near).sign() == Sign::zero)
    low_ = high_ = near;
  else if (before == value_at(p_, low_).sign() && before == -value_at(p_, to).sign())
    low_ = from, high_ = to;
}

std::vector<RealRoot> RealRoot::all(const Polynomial& p, const Rational& low,
                                    const Rational& high) {
  const Polynomial simple = without_double_roots(p);
  std::vector<RealRoot> found;
  if (value_at(simple, low).sign() == Sign::zero) found.push_back(RealRoot(simple, low, low));
  const Chain chain(simple);
  std::vector<Interval> open{{low, high}};  // without their lower ends
  while (!open.empty()) {
    const Interval part = std::move(open.back());
    open.pop_back();
    const int count = chain.roots_between(part.low, part.high);
    if (count == 0) continue;
    if (count == 1 && value_at(simple, part.low).sign() != Sign::zero) {
      found.push_back(RealRoot(simple, part.low, part.high));
      continue;
    }
    const Rational middle = (part.low + part.high) / 2;
    open.push_back({middle, part.high});
    open.push_back({part.low, middle});
  }
  return found;
}

// Of 2^bits_ equal parts the one that the chord crosses, or all before or behind it. Where it holds the
// root, the next are of twice as many bits, else of half as many: at last of one, which halves.
void RealRoot::refine() const {
  constexpr int kMostBits = 512;
  if (low_ == high_) return;
  const Rational size = high_ - low_, parts = std::ldexp(1.0, bits_);
  const Rational at_low = value_at(p_, low_), at_high = value_at(p_, high_);
  const Rational crossed = (at_low / (at_low - at_high) * parts).floor();
  const Rational from = low_ + size * crossed / parts, to = low_ + size * (crossed + 1) / parts;
  const auto sign_at = [&](const Rational& x) { return value_at(p_, x).sign(); };
  const Sign before = at_low.sign(), at_from = sign_at(from), at_to = sign_at(to);
  if (at_from == Sign::zero || at_to == Sign::zero) {
    low_ = high_ = at_from == Sign::zero ? from : to;
    return;
  }
  const bool is_behind = at_to == before, is_ahead = at_from != before;
  (is_behind ? low_ : high_) = is_ahead ? from : to;
  if (is_behind || is_ahead) {
    bits_ = std::max(1, bits_ / 2);
    return;
  }
  low_ = from;
  bits_ = std::min(kMostBits, 2 * bits_);
}

Sign RealRoot::sign_of(const Polynomial& q) const {
  for (bool asked = false;; refine()) {
    if (low_ == high_) return value_at(q, low_).sign();
    const Interval range = range_of(q, {low_, high_});
    const Sign sign = range.low.sign();
    if (sign != Sign::zero && sign == range.high.sign()) return sign;
    if (!std::exchange(asked, true) && has_root_in(common_divisor(p_, q), low_, high_))
      return Sign::zero;
  }
}

RealRoot RealRoot::value_of(const Polynomial& q, Polynomial over) const {
  trim(over);
  const auto by_value = [&] { return RealRoot(value_at(q, low_) / value_at(over, low_)); };
  if (low_ == high_) return by_value();
  if (over.size() > 1 || over[0] != Rational(1)) {
    const Polynomial p = divide(p_, common_divisor(p_, over)).quotient;
    return RealRoot(p, low_, high_).value_of(divide(product(q, inverse(over, p)), p).rest);
  }
  const Polynomial values = without_double_roots(polynomial_of_values(p_, q));
  const Chain chain(values);
  for (;; refine()) {
    if (low_ == high_) return by_value();
    const auto [low, high] = range_of(q, {low_, high_});
    const int at_low = value_at(values, low).sign() == Sign::zero ? 1 : 0;
    if (chain.roots_between(low, high) + at_low != 1) continue;
    return at_low == 1 ? RealRoot(low) : RealRoot(values, low, high);
  }
}

double RealRoot::nearest() const {
  if (sign() == Sign::zero) return 0;
  for (;; refine()) {
    const double low = low_.nearest(), high = high_.nearest();
    if (low == high) return low + 0.0;
    if (std::nextafter(low, high) != high || std::isinf(low) || std::isinf(high)) continue;
    const Rational middle = (Rational(low) + Rational(high)) / 2;
    const Sign side = sign_of({-middle, 1});
    return (side == Sign::zero ? middle.nearest() : side == Sign::positive ? high : low) + 0.0;
  }
}

std::strong_ordering compare(const RealRoot& a, const RealRoot& b) {
  const Rational low = std::max(a.low_, b.low_), high = std::min(a.high_, b.high_);
  if (low <= high && has_root_in(common_divisor(a.p_, b.p_), low, high))
    return std::strong_ordering::equal;
  for (;; a.refine(), b.refine()) {
    if (a.high_ < b.low_) return std::strong_ordering::less;
    if (b.high_ < a.low_) return std::strong_ordering::greater;
  }
}

}  // namespace flatray
