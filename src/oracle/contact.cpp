#include "oracle/contact.h"

#include <cmath>
#include <vector>

namespace flatray::oracle {
namespace {

using Ring = std::span<const Vec2>;

struct Axis {
  Rational x, y;
};

Rational along(const Axis& axis, const Vec2& p) { return axis.x * p.x() + axis.y * p.y(); }

bool is_parallel(const Axis& a, const Axis& b) { return a.x * b.y == a.y * b.x; }

std::vector<Axis> edges(Ring ring) {
  std::vector<Axis> all;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 &from = ring[i], &to = ring[(i + 1) % ring.size()];
    if (from != to) all.push_back({Rational(to.x()) - from.x(), Rational(to.y()) - from.y()});
  }
  return all;
}

// Times that satisfy every condition so far, closed; and whether some satisfy all strictly.
class Times {
 public:
  // low <= speed * t <= high
  void require(const Rational& low, const Rational& speed, const Rational& high) {
    if (speed.sign() == Sign::zero) {
      never_ = never_ || low > 0 || high < 0;
      never_inside_ = never_inside_ || low >= 0 || high <= 0;
      return;
    }
    const Rational a = low / speed, b = high / speed;
    const Rational &first = a < b ? a : b, &last = a < b ? b : a;
    if (!first_ || first > *first_) first_ = first;
    if (!last_ || last < *last_) last_ = last;
  }
  bool empty(const std::optional<Rational>& low, const std::optional<Rational>& high) const {
    return never_ || exceeds(first_, last_) || exceeds(low, last_) || exceeds(first_, high);
  }
  // Whether a time in [low, high] satisfies all strictly.
  bool inside(const std::optional<Rational>& low, const std::optional<Rational>& high) const {
    const auto reaches = [](const auto& a, const auto& b) { return a && b && *a >= *b; };
    return !never_ && !never_inside_ && !reaches(first_, last_) && !reaches(low, last_) &&
           !reaches(first_, high);
  }
  const std::optional<Rational>& first() const { return first_; }
  const std::optional<Rational>& last() const { return last_; }

 private:
  static bool exceeds(const std::optional<Rational>& a, const std::optional<Rational>& b) {
    return a && b && *a > *b;
  }
  bool never_ = false, never_inside_ = false;
  std::optional<Rational> first_, last_;
};

std::optional<Rational> bound(double t) {
  return std::isinf(t) ? std::nullopt : std::optional<Rational>(t);
}

void shadows(const Axis& axis, Ring ring, Rational& low, Rational& high) {
  low = high = along(axis, ring[0]);
  for (const Vec2& p : ring) {
    const Rational s = along(axis, p);
    if (s < low) low = s;
    if (s > high) high = s;
  }
}

}  // namespace

ContactTruth contact_truth(Ring a, const Vec2& velocity_a, Ring b, const Vec2& velocity_b,
                           Range within) {
  std::vector<Axis> directions = edges(a);
  for (Axis& edge : edges(b)) directions.push_back(std::move(edge));
  bool has_area = false;
  for (const Axis& edge : directions) has_area |= !is_parallel(edge, directions.front());
  // Across every edge, along it where nothing else bounds the shapes, and the axes of points.
  std::vector<Axis> axes = {{1, 0}, {0, 1}};
  for (const Axis& edge : directions) {
    axes.push_back({-edge.y, edge.x});
    axes.push_back(edge);
  }
  Times times;
  for (const Axis& axis : axes) {
    Rational low_a, high_a, low_b, high_b;
    shadows(axis, a, low_a, high_a);
    shadows(axis, b, low_b, high_b);
    times.require(low_a - high_b, along(axis, velocity_b) - along(axis, velocity_a),
                  high_a - low_b);
  }
  ContactTruth truth;
  const std::optional<Rational> zero(0), low = bound(within.low), high = bound(within.high);
  if (!times.empty(zero, zero))
    truth.start = has_area && times.inside(zero, zero) ? StartPlace::inside : StartPlace::boundary;
  if (times.empty(low, high)) return truth;
  truth.first = !times.first() || (low && *low > *times.first()) ? low : times.first();
  truth.last = !times.last() || (high && *high < *times.last()) ? high : times.last();
  const bool one_instant = truth.first && truth.last && *truth.first == *truth.last;
  truth.kind = has_area && times.inside(low, high)       ? HitClass::through
               : one_instant || velocity_a == velocity_b ? HitClass::touch
                                                         : HitClass::along;
  return truth;
}

}  // namespace flatray::oracle
