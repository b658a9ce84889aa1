// Places of Bezier curves in plain doubles.

#include "geom/cubic.h"
#include "geom/decide.h"
#include "geom/primitives/bezier.h"
#include "geom/primitives/wall.h"

namespace flatray {
namespace {

// A polynomial of degree up to 5 by its Bernstein coefficients.
using Plain = SmallVector<double, 6>;

int sign_changes(const Plain& c) {
  int changes = 0;
  for (std::size_t k = 0; k + 1 < c.size(); ++k) changes += (c[k] < 0) != (c[k + 1] < 0) ? 1 : 0;
  return changes;
}

// Calls use(s) for each s at which it changes its sign between `low` and `high`, and where it may be
// twice 0, about.
template <class Use>
void visit_roots(const Plain& p, double low, double high, const Use& use) {
  const int changes = sign_changes(p);
  if (changes == 0) return;
  if (changes > 1 && high - low > 0x1p-53) {
    const auto parts = halves(p, 0.5);
    const double middle = 0.5 * (low + high);
    visit_roots(parts[0], low, middle, use);
    visit_roots(parts[1], middle, high, use);
    return;
  }
  use(low + (high - low) * sign_change([&](double s) { return bernstein_value(p, s); }, 0, 1));
}

}  // namespace

Vec2 point_at(const Bezier& curve, double s) {
  const Pair<double> point = point_at(kPlain, curve, s);
  return {point.x, point.y};
}

Vec2 tangent_at(const Bezier& curve, double s) {
  const Pair<double> rate = rate_at(kPlain, curve, s);
  return {rate.x, rate.y};
}

static double weight_at(const Bezier& curve, double s) {
  return curve.is_weighted() ? bernstein_value(weights_of(kPlain, curve), s) : 1;
}

double speed_at(const Bezier& curve, double s) {
  const double weight = weight_at(curve, s);
  return size_of(tangent_at(curve, s)) / (weight * weight);
}

double bend_at(const Bezier& curve, double s) {
  const auto bend = [&](int axis) {
    return bernstein_value(bernstein_derivative(rates_of(kPlain, curve, axis)), s);
  };
  return cross(tangent_at(curve, s), Vec2(bend(0), bend(1)));
}

double curvature_at(const Bezier& curve, double s) {
  const double speed = size_of(tangent_at(curve, s)), weight = weight_at(curve, s);
  return std::fabs(bend_at(curve, s)) / (speed * speed * speed) * (weight * weight);
}

// Of r / w^2 it is r' / w^2 - 2 w' r / w^3.
double most_acceleration(const Bezier& curve) {
  const auto legs = legs_of(curve);
  double longest = legs[0].stableNorm(), most = 0;
  for (std::size_t k = 1; k < legs.size(); ++k) {
    longest = std::max(longest, legs[k].stableNorm());
    most = std::max(most, (legs[k] - legs[k - 1]).stableNorm());
  }
  if (!curve.is_weighted()) return curve.degree * (curve.degree - 1) * most;
  const double least = std::min(0.5 + 0.5 * curve.weight, 1.0);
  const double steepest = 2 * std::fabs(curve.weight - 1);
  return (4 * most + 4 * steepest * longest / least) / (least * least);
}

// An end, or where the way from the point stands upright on the curve: where w(s) . w'(s) = 0, w the
// curve as seen from it, whose coefficients are sums of those of both.
double parameter_near(const Bezier& curve, const Vec2& point) {
  constexpr double kChoices[6][6] = {{1},          {1, 1},          {1, 2, 1},
                                     {1, 3, 3, 1}, {1, 4, 6, 4, 1}, {1, 5, 10, 10, 5, 1}};
  const Bounds box = bounds_of(curve);
  const double size =
      box.low.cwiseAbs().cwiseMax(box.high.cwiseAbs()).cwiseMax(point.cwiseAbs()).maxCoeff();
  const Bezier seen = mapped(curve, [&](const Vec2& p) { return Vec2(p / size - point / size); });
  const auto from = bernstein_of(kPlain, seen, [](const Vec2& p) { return p; });
  const auto legs = legs_of(seen);
  const std::size_t n = from.size() - 1, m = legs.size() - 1;
  Plain upright;
  for (std::size_t i = 0; i <= n + m; ++i) upright.push_back(0);
  for (std::size_t i = 0; i <= n; ++i)
    for (std::size_t k = 0; k <= m; ++k)
      upright[i + k] +=
          kChoices[n][i] * kChoices[m][k] / kChoices[n + m][i + k] * from[i].dot(legs[k]);
  double best = 0, least = kInfinity;
  const auto look = [&](double s) {
    const double distance = (point_at(curve, s) - point).stableNorm();
    if (distance < least) best = s, least = distance;
  };
  look(0);
  visit_roots(upright, 0, 1, look);
  look(1);
  return best;
}

// From the first of its points along its line to the last.
Segment stretch_of(const Bezier& curve) {
  const Bounds box = bounds_of(curve);
  const Vec2 extent = box.high - box.low;
  const int axis = extent.x() < extent.y() ? 1 : 0;
  const auto legs = legs_of(curve);
  Plain rate;
  for (const Vec2& leg : legs) rate.push_back(leg[axis]);
  Segment stretch{curve.start(), curve.start()};
  const auto look = [&](const Vec2& point) {
    if (point[axis] < stretch.a[axis]) stretch.a = point;
    if (point[axis] > stretch.b[axis]) stretch.b = point;
  };
  visit_roots(rate, 0, 1, [&](double s) { look(point_at(curve, s)); });
  look(curve.end());
  return stretch;
}

}  // namespace flatray
