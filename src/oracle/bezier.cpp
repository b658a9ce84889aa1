#include "oracle/bezier.h"

#include <algorithm>
#include <span>
#include <utility>

#include "base/check.h"
#include "oracle/point.h"

namespace flatray::oracle {
namespace {

// The sum of a x and b y over a curve, less that at `from`, by powers of s: the k-th difference of the
// control points times n over k.
Polynomial along(const Rational& a, const Rational& b, const Vec2& from,
                 std::span<const Vec2> points) {
  Polynomial left;
  for (const Vec2& p : points)
    left.push_back(a * (Rational(p.x()) - from.x()) + b * (Rational(p.y()) - from.y()));
  Polynomial powers;
  Rational choices = 1;
  for (std::size_t k = 0; k < points.size(); ++k) {
    powers.push_back(choices * left[0]);
    choices *= static_cast<double>(points.size() - 1 - k);
    choices /= static_cast<double>(k + 1);
    for (std::size_t i = 0; i + 1 < left.size(); ++i) left[i] = left[i + 1] - left[i];
    left.pop_back();
  }
  return powers;
}

struct Order {
  int multiplicity = 0;
  Sign slope = Sign::zero;  // of the first derivative that is not 0
};
Order order_of(const Algebraic& root, Polynomial p) {
  Order order;
  for (; order.slope == Sign::zero; ++order.multiplicity) {
    p = oracle::derivative(p);
    order.slope = root.sign_of(p);
  }
  return order;
}

bool is_cusp(const Algebraic& s, std::span<const Vec2> points) {
  return s.sign_of(oracle::derivative(along(1, 0, points[0], points))) == Sign::zero &&
         s.sign_of(oracle::derivative(along(0, 1, points[0], points))) == Sign::zero;
}

std::vector<BezierMeeting> meetings_with_point(const Vec2& point, std::span<const Vec2> points) {
  const Polynomial both = common_divisor(along(1, 0, point, points), along(0, 1, point, points));
  FLATRAY_CHECK(!both.empty(), "a curve is a point");
  std::vector<BezierMeeting> found;
  for (const Algebraic& s : Algebraic::roots(both, 0, 1))
    found.push_back({Algebraic(Surd{}), s, 0, Root::none, is_cusp(s, points)});
  return found;
}

// What is linear along a ray: at its origin, and with t.
struct Linear {
  Rational start, rate;
  Sign sign_at(const Surd& t) const { return t.mapped(start, rate).sign(); }
};

// A weighted quadratic curve with the control points a, b, c and the weight w of b is where the shares u, v, x
// of these in a point (which sum to 1) are 0 or more and v^2 = 4 w^2 u x. That difference is negative towards the
// chord.
std::vector<BezierMeeting> meetings_with_conic(const Ray& ray, const Bezier& curve) {
  const Point way = exact(ray.direction);
  const auto seen = [&](const Vec2& p) { return exact(p) - exact(ray.origin); };
  const Point a = seen(curve.point(0)), b = seen(curve.point(1)), c = seen(curve.point(2));
  const auto area = [&](const Point& p, const Point& q) {
    return Linear{cross(p, q), cross(q - p, way)};
  };
  const Linear u = area(b, c), v = area(c, a), x = area(a, b);
  const bool turns_left = u.start + v.start + x.start > 0;
  const Rational four = Rational(4) * curve.weight * curve.weight;
  const Rational constant = v.start * v.start - four * u.start * x.start;
  const Rational linear = v.start * v.rate * 2 - four * (u.start * x.rate + u.rate * x.start);
  const Rational square = v.rate * v.rate - four * u.rate * x.rate;
  std::vector<BezierMeeting> found;
  const auto add = [&](const Surd& t, int multiplicity, bool falls) {
    const Sign turn = turns_left ? Sign::positive : Sign::negative;
    const Sign first = u.sign_at(t) * turn, middle = v.sign_at(t) * turn,
               last = x.sign_at(t) * turn;
    const bool is_on =
        first != Sign::negative && middle != Sign::negative && last != Sign::negative;
    if (!is_on || t.sign() == Sign::negative) return;
    const Rational s = last == Sign::zero ? 0 : first == Sign::zero ? 1 : 0.5;
    const Root root = multiplicity == 0     ? Root::none
                      : multiplicity == 2   ? Root::both
                      : falls == turns_left ? Root::second
                                            : Root::first;
    found.push_back({Algebraic(t), Algebraic(Surd{s, 0, 0}), multiplicity, root, false});
  };
  if (square == 0 && linear == 0) {
    if (constant == 0) add({0, 0, 0}, 0, false);
  } else if (square == 0) {
    add({-constant / linear, 0, 0}, 1, linear < 0);
  } else {
    const Rational middle = -linear / (square * 2), rest = middle * middle - constant / square;
    if (rest == 0) add({middle, 0, 0}, 2, false);
    if (!(rest > 0)) return found;
    add({middle, -1, rest}, 1, square > 0);
    add({middle, 1, rest}, 1, square < 0);
  }
  return found;
}

}  // namespace

std::vector<BezierMeeting> meetings_with_bezier(const Ray& ray, const Bezier& curve) {
  if (curve.is_weighted()) return meetings_with_conic(ray, curve);
  const std::span points(curve.points.data(), static_cast<std::size_t>(curve.degree) + 1);
  const Rational dx = ray.direction.x(), dy = ray.direction.y(), square = dx * dx + dy * dy;
  if (square == 0) return meetings_with_point(ray.origin, points);
  const Polynomial beside = along(-dy, dx, ray.origin, points);
  const Polynomial ahead = along(dx / square, dy / square, ray.origin, points);
  FLATRAY_CHECK(std::any_of(beside.begin(), beside.end(), [](const auto& c) { return c != 0; }),
                "a curve lies along a ray");
  std::vector<BezierMeeting> found;
  int entries = 0, exits = 0;
  for (const Algebraic& s : Algebraic::roots(beside, 0, 1)) {
    const Order order = order_of(s, beside);
    Root root = Root::both;
    if (order.multiplicity % 2 == 1 && order.slope == Sign::positive)
      root = entries++ == 0 ? Root::first : Root::third;
    else if (order.multiplicity % 2 == 1)
      root = exits++ == 0 ? Root::second : Root::fourth;
    if (s.sign_of(ahead) != Sign::negative)
      found.push_back({s.value_of(ahead), s, order.multiplicity, root, is_cusp(s, points)});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.t < b.t; });
  return found;
}

std::optional<WallHitOf<Algebraic>> first_wall_hit(const Ray& ray, const Bezier& curve) {
  const std::vector<BezierMeeting> all = meetings_with_bezier(ray, curve);
  if (all.empty()) return std::nullopt;
  WallHitOf<Algebraic> first{all[0].t, HitClass::touch, all[0].root, false};
  for (const BezierMeeting& met : all) {
    if (&met != all.data() && met.t != first.t) break;
    if (met.multiplicity % 2 == 1) first.kind = HitClass::through, first.root = met.root;
    first.at_end = first.at_end || met.at_end() || &met != all.data();
  }
  return first;
}

}  // namespace flatray::oracle
