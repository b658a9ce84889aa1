#include "oracle/bezier.h"

#include <algorithm>
#include <span>

#include "base/check.h"

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

}  // namespace

std::vector<BezierMeeting> meetings_with_bezier(const Ray& ray, const Bezier& curve) {
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
    if (met.t != first.t) break;
    if (met.multiplicity % 2 == 1) first.kind = HitClass::through, first.root = met.root;
    first.at_end = first.at_end || met.at_end() || &met != all.data();
  }
  return first;
}

}  // namespace flatray::oracle
