#include "geom/primitives/bezier.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "geom/decide.h"
#include "geom/predicates.h"
#include "geom/primitives/bezier_roots.h"
#include "geom/primitives/wall.h"

namespace flatray {
namespace {

// Without their names; s_of(s) encloses what s does.
template <class Found, class Enclose>
std::vector<BezierRoot> told(const std::vector<Found>& roots, const Enclose& s_of) {
  std::vector<BezierRoot> told;
  for (const auto& [near, multiplicity, slope] : roots) {
    const auto s = s_of(near);
    told.push_back({Root::none, static_cast<int>(told.size()), multiplicity, slope,
                    Bounded(s.value(), s.error()), false});
  }
  return told;
}

template <class Make>
std::optional<std::vector<BezierRoot>> enclosed_roots(const Make& number, const Bezier& curve,
                                                      const Ray& ray) {
  const auto plain = [](const auto& x) { return x.hi(); };
  const auto roots = bernstein_roots(number, plain, beside_ray(number, curve, ray), 2);
  if (!roots) return std::nullopt;
  return told(*roots, [](const auto& s) { return s; });
}

// Those that doubles tell apart, each by one more step of Newton's method, which makes twice the digits though
// its slope is known to doubles only.
std::optional<std::vector<BezierRoot>> refined_roots(const Bezier& curve, const Ray& ray) {
  const auto plain = [](const Near& x) { return x.value(); };
  const Bernstein<Quick> beside = beside_ray(kQuick, curve, ray);
  Bernstein<Near> rounded;
  for (const Quick& c : beside) rounded.push_back(near_of(c));
  const auto roots = bernstein_roots(kNear, plain, rounded, 1);
  if (!roots) return std::nullopt;
  const Bernstein<Near> rise = bernstein_derivative(rounded);
  return told(*roots, [&](const Near& near) {
    const Quick s = near.value();
    const Near slope = bernstein_value(rise, near);
    return s - bernstein_value(beside, s) / Quick::within(slope.value(), slope.error());
  });
}

std::optional<std::vector<BezierRoot>> quick_roots(const Bezier& curve, const Ray& ray) {
  std::optional<std::vector<BezierRoot>> quick;
  with_fused([&] {
    quick = refined_roots(curve, ray);
    if (!quick) quick = enclosed_roots(kQuick, curve, ray);
  });
  return quick ? quick : enclosed_roots(kBounded, curve, ray);
}

// With its nearest double, and that of what is left.
Bounded enclosure_of(const RealRoot& s) {
  const double near = s.nearest();
  if (s.sign_of({-Rational(near), 1}) == Sign::zero) return near;
  const double rest = s.value_of({-Rational(near), 1}).nearest();
  return Bounded(near) + Bounded::within(rest, 0x1p-52 * std::fabs(rest) + kUnderflowError);
}

std::vector<BezierRoot> rational_roots(const Bezier& curve, const Ray& ray) {
  const Polynomial beside = powers_of(beside_ray(kRational, curve, ray));
  FLATRAY_CHECK(std::any_of(beside.begin(), beside.end(),
                            [](const Rational& c) { return c.sign() != Sign::zero; }),
                "a Bezier curve lies along a ray");
  const Polynomial along[] = {powers_of(rates_of(kRational, curve, 0)),
                              powers_of(rates_of(kRational, curve, 1))};
  std::vector<BezierRoot> found;
  for (const RealRoot& s : RealRoot::all(beside, 0, 1)) {
    BezierRoot root{Root::none, static_cast<int>(found.size()),     0, Sign::zero, enclosure_of(s),
                    false,      std::make_shared<const RealRoot>(s)};
    for (Polynomial p = beside; root.slope == Sign::zero; ++root.multiplicity) {
      p = derivative(p);
      root.slope = s.sign_of(p);
    }
    root.at_cusp = root.multiplicity > 1 && s.sign_of(along[0]) == Sign::zero &&
                   s.sign_of(along[1]) == Sign::zero;
    found.push_back(root);
  }
  return found;
}

// A curve x / weights, y / weights.
struct WeightedHull {
  Bernstein<double> x, y, weights;

  bool is_past(const Bernstein<double>& c, double side) const {
    bool above = true, below = true;
    for (std::size_t k = 0; k < c.size(); ++k) {
      above = above && c[k] > side * weights[k];
      below = below && c[k] < -side * weights[k];
    }
    return above || below;
  }
  // Whether a part of it may lie in a box about 0, by halves of it.
  bool passes(const Vec2& half, int halvings) const {
    if (is_past(x, half.x()) || is_past(y, half.y())) return false;
    if (halvings == 0) return true;
    const auto xs = halves(x, 0.5), ys = halves(y, 0.5), ws = halves(weights, 0.5);
    return WeightedHull{xs[0], ys[0], ws[0]}.passes(half, halvings - 1) ||
           WeightedHull{xs[1], ys[1], ws[1]}.passes(half, halvings - 1);
  }
};

HitTime time_of(const Bezier& wall, const Ray& ray, const BezierRoot& root) {
  if (root.is_end()) return HitTime::abreast(ray, root.s.hi() == 0 ? wall.start() : wall.end());
  return HitTime::on_curve(ray, wall, root);
}

// The polynomial by powers of s whose roots are the parameters at which a cubic crosses itself; constant
// where it does nowhere. With the powers a s^3 + b s^2 + c s + d of the curve the sum of both is
// c x a / a x b, and its square less their product b x c / a x b.
template <class Make>
auto self_crossings(const Make& number, const Bezier& wall) {
  const auto p = [&](int k) { return pair_of(number, wall.point(k)); };
  const auto three = number(3);
  const auto c = three * (p(1) - p(0)), b = three * (p(2) - p(1)) - c, a = p(3) - p(0) - c - b;
  const auto ab = cross(a, b), ca = cross(c, a);
  return std::array{ca * ca - ab * cross(b, c), -(ab * ca), ab * ab};
}

bool is_crossing_of_itself(const Bezier& wall, const Ray& ray, const BezierRoot& root) {
  if (wall.degree < 3) return false;
  const auto near = self_crossings(kBounded, wall);
  const auto sign = (near[0] + root.s * (near[1] + root.s * near[2])).sign();
  if (sign && *sign != Sign::zero) return false;
  const auto exact = self_crossings(kRational, wall);
  if (exact[2].sign() == Sign::zero) return false;
  return exact_parameter(wall, ray, root).sign_of({exact.begin(), exact.end()}) == Sign::zero;
}

// On which side of the curve a point lies that is near it: by where the line along an axis through it,
// the one more upright on the curve, meets the curve nearest to it.
struct Level {
  Sign side;  // zero where it is on the curve
  PlaceOn place;
};
Level level_of(const Bezier& wall, const Vec2& point) {
  const Vec2 tangent = tangent_at(wall, parameter_near(wall, point));
  const bool is_upright = std::fabs(tangent.y()) > std::fabs(tangent.x());
  const Ray ray{point, is_upright ? Vec2(1, 0) : Vec2(0, 1)};
  Level level{Sign::zero, PlaceOn::outside};
  double nearest = kInfinity;
  const Bernstein<Bounded> ahead_of = ahead_of_ray(kBounded, wall, ray);
  for (const BezierRoot& root : roots_of(wall, ray)) {
    const Bounded way = form_at(kBounded, wall, ahead_of, root.s);
    const Sign ahead = way.sign() ? *way.sign() : time_of(wall, ray, root).sign();
    if (ahead == Sign::zero) {
      const bool again = level.place != PlaceOn::outside;
      level.place = root.is_corner() || again ? PlaceOn::at_end : PlaceOn::inner;
      continue;
    }
    const double distance = std::fabs(way.hi());
    if (root.root == Root::both || distance >= nearest) continue;
    nearest = distance;
    level.side = enters(root.root) ? ahead : -ahead;
  }
  if (level.place != PlaceOn::outside) level.side = Sign::zero;
  return level;
}

}  // namespace

bool is_on_one_line(const Bezier& curve) {
  const Vec2& start = curve.start();
  for (int i = 1; i < curve.degree; ++i)
    for (int k = i + 1; k <= curve.degree; ++k)
      if (orientation(start, curve.point(i), curve.point(k)) != Sign::zero) return false;
  return true;
}

Polynomial powers_of(Bernstein<Rational> c) {
  Polynomial powers;
  const std::size_t n = c.size() - 1;
  for (Rational choices = 1; !c.empty(); c.pop_back()) {
    powers.push_back(choices * c.front());
    for (std::size_t k = 0; k + 1 < c.size(); ++k) c[k] = c[k + 1] - c[k];
    choices *= static_cast<double>(c.size() - 1);
    choices /= static_cast<double>(n + 2 - c.size());
  }
  return powers;
}

std::vector<BezierRoot> roots_of(const Bezier& curve, const Ray& ray) {
  auto quick = quick_roots(curve, ray);
  std::vector<BezierRoot> found = quick ? std::move(*quick) : rational_roots(curve, ray);
  RootNames names;
  for (BezierRoot& root : found) root.root = names.next(root.multiplicity, root.slope);
  return found;
}

BezierRoot root_of(const Bezier& curve, const Ray& ray, Root root) {
  const std::vector<BezierRoot> all = roots_of(curve, ray);
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const BezierRoot& one) { return one.root == root; });
  FLATRAY_CHECK(found != all.end(), "a ray does not meet a curve in the root asked for");
  return *found;
}

RealRoot exact_parameter(const Bezier& curve, const Ray& ray, const BezierRoot& root) {
  if (root.exact) return *root.exact;
  return RealRoot::all(powers_of(beside_ray(kRational, curve, ray)), 0,
                       1)[static_cast<std::size_t>(root.index)];
}

RealRoot exact_form(const Bezier& curve, const Ray& ray, const BezierRoot& root,
                    const Bernstein<Rational>& form) {
  return exact_parameter(curve, ray, root)
      .value_of(powers_of(form), powers_of(weights_of(kRational, curve)));
}

// It lies in the hull of its control points.
Bounds bounds_of(const Bezier& wall) {
  Bounds box;
  for (int k = 0; k <= wall.degree; ++k) box.add(wall.point(k));
  return box;
}

// At its ends, and where a coordinate turns back: with A, B, C the Bernstein coefficients of its rate and
// r = s / (1 - s), where A + B r + C r^2 = 0. Of parabolas the rate has two.
Bounds extent_of(const Bezier& curve) {
  Bounds box;
  box.add(curve.start());
  box.add(curve.end());
  for (const int axis : {0, 1}) {
    const auto rates = rates_of(kPlain, curve, axis);
    const bool linear = rates.size() == 2;
    double a = rates[0], b = linear ? rates[0] + rates[1] : 2 * rates[1], c = rates.back();
    const double largest = std::max({std::fabs(a), std::fabs(b), std::fabs(c)});
    a /= largest, b /= largest, c /= largest;
    const double q = -0.5 * (b + std::copysign(std::sqrt(b * b - 4 * a * c), b));
    for (const double r : {q / c, a / q})
      if (r > 0 && std::isfinite(r)) box.add(point_at(curve, r / (1 + r)));
  }
  return box;
}

// Halves of a polygon of control points round each of them by at most an ulp of the largest a time, times its weight.
// A heavy middle point draws all but the ends of the parameter's range to it.
bool passes_near(const Bezier& wall, const Vec2& point, const Vec2& reach) {
  const int halvings = 6 + std::ilogb(std::max(wall.weight, 1.0));
  const Bounds box = bounds_of(wall);
  const Vec2 largest = box.low.cwiseAbs().cwiseMax(box.high.cwiseAbs()).cwiseMax(point.cwiseAbs());
  const Vec2 half =
      reach + 0x1p-45 * largest + Vec2::Constant(kUnderflowError / std::min(wall.weight, 1.0));
  const auto from = [&](int axis) {
    return bernstein_of(kPlain, wall, [&](const Vec2& p) { return p[axis] - point[axis]; });
  };
  return WeightedHull{from(0), from(1), weights_of(kPlain, wall)}.passes(half, halvings);
}

Sign side_of(const Bezier& wall, const Vec2& point) { return level_of(wall, point).side; }

PlaceOn place_on(const Bezier& wall, const Vec2& point) {
  return bounds_of(wall).contains(point) ? level_of(wall, point).place : PlaceOn::outside;
}

HitTime time_met(const Bezier& wall, const Ray& ray, Root root) {
  return time_of(wall, ray, root_of(wall, ray, root));
}

// Where the curve crosses itself both roots are one meeting in a corner.
void meet(const Bezier& wall, const Ray& ray, const MeetingRules& rules,
          std::vector<WallMeeting>& met) {
  const std::vector<BezierRoot> roots = roots_of(wall, ray);
  std::optional<std::size_t> corner;
  for (const BezierRoot& root : roots) {
    const bool crosses = root.root != Root::both;
    const bool is_double = roots.size() > 1 && is_crossing_of_itself(wall, ray, root);
    if (!crosses && !rules.tangents && !root.is_corner() && !is_double) continue;
    const HitTime time = time_of(wall, ray, root);
    const Sign ahead = time.sign();
    if (ahead == Sign::negative || (ahead == Sign::zero && rules.stood_on != Root::none)) continue;
    const HitClass kind = crosses ? HitClass::through : HitClass::touch;
    if (!is_double || !corner) {
      if (is_double) corner = met.size();
      met.push_back({time, kind, root.root, root.is_corner()});
      continue;
    }
    WallMeeting& both = met[*corner];
    both.at_end = true;
    if (crosses) both.kind = kind, both.root = root.root;
  }
}

std::vector<HitInterval> clip_curve(const Ray& ray, const Bezier& curve, Range within) {
  std::vector<HitInterval> hits;
  const auto add = [&](RoundedTime time, double way, bool at_origin) {
    HitInterval& hit = hits.emplace_back();
    hit.kind = HitClass::touch;
    hit.t_enter = hit.t_exit = way * time.t;
    hit.enter_overflows = hit.exit_overflows = time.overflows;
    hit.start = at_origin ? StartPlace::boundary : StartPlace::outside;
  };
  if (ray.direction == Vec2(0, 0)) {
    if (place_on(curve, ray.origin) != PlaceOn::outside && within.low <= 0 && within.high >= 0)
      add({0, false}, 1, true);
    return hits;
  }
  for (const double way : {-1.0, 1.0}) {
    std::vector<WallMeeting> met;
    meet(curve, {ray.origin, way * ray.direction}, {Root::none, true, true}, met);
    std::sort(met.begin(), met.end(), [&](const WallMeeting& a, const WallMeeting& b) {
      const auto order = compare(a.time, b.time);
      return way > 0 ? order < 0 : order > 0;
    });
    const double least = way > 0 ? within.low : -within.high,
                 most = way > 0 ? within.high : -within.low;
    for (const WallMeeting& one : met) {
      const bool at_origin = one.time.sign() == Sign::zero;
      if (one.time.compare(least) >= 0 && one.time.compare(most) <= 0 && (way > 0 || !at_origin))
        add(one.time.nearest(), way, at_origin);
    }
  }
  return hits;
}

bool is_crossed(const Bezier& wall, const Ray& ray) {
  const std::vector<BezierRoot> all = roots_of(wall, ray);
  return std::any_of(all.begin(), all.end(),
                     [](const BezierRoot& one) { return one.root != Root::both; });
}

Vec2 end_met(const Bezier& wall, const Ray& ray, Root root) {
  const BezierRoot met = root_of(wall, ray, root);
  if (met.is_end()) return met.s.hi() == 0 ? wall.start() : wall.end();
  return point_met(wall, ray, root);
}

Vec2 point_met(const Bezier& wall, const Ray& ray, Root root) {
  return ExactHit(ray, wall, root).nearest();
}

bool leads_away(const Bezier& wall, Sign side, const Ray& ray) {
  const double s = parameter_near(wall, ray.origin);
  return side == decide([&](const auto& number) {
           return cross(rate_at(number, wall, number(s)), pair_of(number, ray.direction));
         });
}

Vec2 normal_near(const Bezier& wall, const Vec2& point) {
  const Vec2 tangent = tangent_at(wall, parameter_near(wall, point));
  return {-tangent.y(), tangent.x()};
}

bool overlap(const Bezier& one, const Bezier& other) {
  if (one.degree != other.degree || one.weight != other.weight) return false;
  const std::span points(one.points.data(), static_cast<std::size_t>(one.degree) + 1);
  return std::equal(points.begin(), points.end(), other.points.begin()) ||
         std::equal(points.rbegin(), points.rend(), other.points.begin());
}

// Each end counts where the wall rises from it.
bool crosses_to_right(const Bezier& wall, const Vec2& point) {
  const Ray ray{point, {1, 0}};
  bool crosses = false;
  for (const BezierRoot& root : roots_of(wall, ray)) {
    if (time_of(wall, ray, root).sign() != Sign::positive) continue;
    const bool falls_to_end = root.s.hi() == 1 && root.multiplicity % 2 == 1;
    const Sign beside = falls_to_end ? -root.slope : root.slope;
    crosses ^= root.is_end() ? beside == Sign::positive : root.multiplicity % 2 == 1;
  }
  return crosses;
}

}  // namespace flatray
