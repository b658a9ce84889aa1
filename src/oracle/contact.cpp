#include "oracle/contact.h"

#include <cmath>
#include <vector>

#include "oracle/whole.h"

namespace flatray::oracle {
namespace {

// All below is written once for rationals and once for whole numbers of 128 bits: `Number`.

template <class Number>
struct Vector {
  Number x, y;
  bool operator==(const Vector&) const = default;
  friend Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y}; }
};

template <class Number>
struct Body {
  std::vector<Vector<Number>> ring;
  Vector<Number> velocity;
};

template <class Number>
Number along(const Vector<Number>& axis, const Vector<Number>& p) {
  return axis.x * p.x + axis.y * p.y;
}

template <class Number>
bool is_parallel(const Vector<Number>& a, const Vector<Number>& b) {
  return a.x * b.y == a.y * b.x;
}

template <class Number>
void add_edges(const Body<Number>& body, std::vector<Vector<Number>>& all) {
  for (std::size_t i = 0; i < body.ring.size(); ++i) {
    const auto &from = body.ring[i], &to = body.ring[(i + 1) % body.ring.size()];
    if (!(from == to)) all.push_back(to - from);
  }
}

// A time as numerator over denominator, which is positive.
Rational quotient(const Rational& a, const Rational& b) { return a / b; }
Fraction quotient(Int128 a, Int128 b) { return b < 0 ? Fraction{-a, -b} : Fraction{a, b}; }

template <class Number>
using Time = decltype(quotient(Number(0), Number(1)));

// Times that satisfy every condition so far, closed; and whether some satisfy all strictly.
template <class Number>
class Times {
  using Bound = std::optional<Time<Number>>;

 public:
  // low <= speed * t <= high
  void require(const Number& low, const Number& speed, const Number& high) {
    const Number zero(0);
    if (speed == zero) {
      never_ = never_ || low > zero || high < zero;
      never_inside_ = never_inside_ || low >= zero || high <= zero;
      return;
    }
    const bool forward = speed > zero;
    const Time<Number> first = quotient(forward ? low : high, speed);
    const Time<Number> last = quotient(forward ? high : low, speed);
    if (!first_ || first > *first_) first_ = first;
    if (!last_ || last < *last_) last_ = last;
  }
  bool empty(const Bound& low, const Bound& high) const {
    return never_ || exceeds(first_, last_) || exceeds(low, last_) || exceeds(first_, high);
  }
  // Whether a time in [low, high] satisfies all strictly.
  bool inside(const Bound& low, const Bound& high) const {
    const auto reaches = [](const auto& a, const auto& b) { return a && b && *a >= *b; };
    return !never_ && !never_inside_ && !reaches(first_, last_) && !reaches(low, last_) &&
           !reaches(first_, high);
  }
  const Bound& first() const { return first_; }
  const Bound& last() const { return last_; }

 private:
  static bool exceeds(const Bound& a, const Bound& b) { return a && b && *a > *b; }
  bool never_ = false, never_inside_ = false;
  Bound first_, last_;
};

template <class Number>
struct Shadow {
  Number low, high;
};

template <class Number>
Shadow<Number> shadow(const Vector<Number>& axis, const Body<Number>& body) {
  Number low = along(axis, body.ring[0]), high = low;
  for (const auto& p : body.ring) {
    const Number s = along(axis, p);
    if (s < low) low = s;
    if (s > high) high = s;
  }
  return {low, high};
}

// Across every edge; where nothing else bounds the shapes also along it; two axes of points.
template <class Number>
std::vector<Vector<Number>> axes_of(const std::vector<Vector<Number>>& directions, bool has_area) {
  if (directions.empty()) return {{1, 0}, {0, 1}};
  std::vector<Vector<Number>> axes;
  for (const auto& edge : directions) {
    axes.push_back({-edge.y, edge.x});
    if (!has_area) axes.push_back(edge);
  }
  return axes;
}

// With times as `Number`s give them.
template <class Number>
struct Answer {
  HitClass kind = HitClass::miss;
  StartPlace start = StartPlace::outside;
  std::optional<Time<Number>> first, last;
};

template <class Number>
Answer<Number> answer(const Body<Number>& a, const Body<Number>& b,
                      const std::optional<Time<Number>>& low,
                      const std::optional<Time<Number>>& high) {
  std::vector<Vector<Number>> directions;
  add_edges(a, directions);
  add_edges(b, directions);
  bool has_area = false;
  for (const auto& edge : directions) has_area |= !is_parallel(edge, directions.front());
  Times<Number> times;
  for (const auto& axis : axes_of(directions, has_area)) {
    const Shadow<Number> of_a = shadow(axis, a), of_b = shadow(axis, b);
    times.require(of_a.low - of_b.high, along(axis, b.velocity) - along(axis, a.velocity),
                  of_a.high - of_b.low);
  }
  Answer<Number> found;
  const std::optional<Time<Number>> zero = quotient(Number(0), Number(1));
  if (!times.empty(zero, zero))
    found.start = has_area && times.inside(zero, zero) ? StartPlace::inside : StartPlace::boundary;
  if (times.empty(low, high)) return found;
  found.first = !times.first() || (low && *low > *times.first()) ? low : times.first();
  found.last = !times.last() || (high && *high < *times.last()) ? high : times.last();
  const bool one_instant = found.first && found.last && *found.first == *found.last;
  found.kind = has_area && times.inside(low, high)       ? HitClass::through
               : one_instant || a.velocity == b.velocity ? HitClass::touch
                                                         : HitClass::along;
  return found;
}

std::optional<Rational> bound(double t) {
  return std::isinf(t) ? std::nullopt : std::optional<Rational>(t);
}

Body<Rational> in_rationals(std::span<const Vec2> ring, const Vec2& velocity) {
  Body<Rational> body{{}, {velocity.x(), velocity.y()}};
  for (const Vec2& p : ring) body.ring.push_back({p.x(), p.y()});
  return body;
}

// 2^exponent, which may be beyond the doubles.
Rational power_of_two(int exponent) {
  Rational power(1);
  for (; exponent > 1000; exponent -= 1000) power *= 0x1p1000;
  for (; exponent < -1000; exponent += 1000) power *= 0x1p-1000;
  return power * std::ldexp(1.0, exponent);
}

Rational in_rationals(Int128 x) {
  constexpr int kDigits = 42;  // thrice, so that each part is a double
  const Int128 middle = x >> kDigits, high = middle >> kDigits;
  const auto digits = [](Int128 part, Int128 above) {
    return static_cast<double>(part - (above << kDigits));
  };
  return (Rational(static_cast<double>(high)) * 0x1p42 + digits(middle, high)) * 0x1p42 +
         digits(x, middle);
}

// All places as whole numbers of one unit, all velocities of another, below 2^60: so axes are below 2^61, what
// lies along them below 2^122, their differences below 2^123, and fractions of those are compared in 256 bits.
// A time fits as a fraction of at most 2^61 over 2^113.
class WholeBodies {
 public:
  WholeBodies(std::span<const Vec2> a, const Vec2& velocity_a, std::span<const Vec2> b,
              const Vec2& velocity_b) {
    std::vector<double> doubles;
    for (const auto ring : {a, b})
      for (const Vec2& p : ring) doubles.insert(doubles.end(), {p.x(), p.y()});
    places_ = whole_numbers(doubles);
    doubles = {velocity_a.x(), velocity_a.y(), velocity_b.x(), velocity_b.y()};
    velocities_ = whole_numbers(doubles);
    of_a_ = a.size();
  }
  explicit operator bool() const { return places_ && velocities_; }
  // Whether a time, in the unit that places and velocities leave, fits; and then that time.
  bool fits(double t) const {
    return t == 0 || std::isinf(t) || std::abs(std::ilogb(t) - unit()) < kMostShift;
  }
  std::optional<Fraction> limit(double t) const {
    if (std::isinf(t)) return std::nullopt;
    if (t == 0) return Fraction{0, 1};
    int exponent = 0;
    const auto digits = static_cast<std::int64_t>(std::frexp(t, &exponent) * 0x1p53);
    const int shift = exponent - 53 - unit();
    return shift < 0 ? Fraction{digits, Int128{1} << -shift} : Fraction{Int128{digits} << shift, 1};
  }
  Body<Int128> a() const { return body(0, of_a_, 0); }
  Body<Int128> b() const { return body(of_a_, places_->numbers.size() / 2, 1); }
  std::optional<Rational> time(const std::optional<Fraction>& t) const {
    if (!t) return std::nullopt;
    return in_rationals(t->numerator) / in_rationals(t->denominator) * power_of_two(unit());
  }

 private:
  static constexpr int kMostShift = 60;
  int unit() const { return places_->exponent - velocities_->exponent; }
  static Vector<Int128> at(const Whole& whole, std::size_t i) {
    return {whole.numbers[2 * i], whole.numbers[2 * i + 1]};
  }
  Body<Int128> body(std::size_t from, std::size_t to, std::size_t which) const {
    Body<Int128> body{{}, at(*velocities_, which)};
    for (std::size_t i = from; i < to; ++i) body.ring.push_back(at(*places_, i));
    return body;
  }
  std::optional<Whole> places_, velocities_;
  std::size_t of_a_ = 0;
};

}  // namespace

ContactTruth contact_truth(std::span<const Vec2> a, const Vec2& velocity_a, std::span<const Vec2> b,
                           const Vec2& velocity_b, Range within) {
  const WholeBodies bodies(a, velocity_a, b, velocity_b);
  if (bodies && bodies.fits(within.low) && bodies.fits(within.high)) {
    const auto found =
        answer<Int128>(bodies.a(), bodies.b(), bodies.limit(within.low), bodies.limit(within.high));
    return {found.kind, bodies.time(found.first), bodies.time(found.last), found.start};
  }
  auto found = answer<Rational>(in_rationals(a, velocity_a), in_rationals(b, velocity_b),
                                bound(within.low), bound(within.high));
  return {found.kind, std::move(found.first), std::move(found.last), found.start};
}

}  // namespace flatray::oracle
