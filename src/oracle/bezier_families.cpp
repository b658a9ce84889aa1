#include "oracle/bezier_families.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace flatray::oracle {
namespace {

using Points = std::vector<Vec2>;
constexpr int kCurves = 8, kWorld = 32;

Vec2 whole_point(Draw& draw, int low, int high) {
  const double x = low + draw.below(high - low);
  return {x, low + draw.below(high - low)};
}
Vec2 any_point(Draw& draw) {
  const double x = draw.unit();
  return {x, draw.unit()};
}

bool lie_on_one_line(const Points& points) {
  const Vec2 way = *std::find_if(points.begin(), points.end() - 1, [&](const Vec2& p) {
    return p != points[0];
  }) - points[0];
  return std::all_of(points.begin(), points.end(), [&](const Vec2& p) {
    return way.x() * (p - points[0]).y() == way.y() * (p - points[0]).x();
  });
}

// A point of a curve and its tangent there.
struct OnCurve {
  Vec2 at, tangent;
};

// A curve and points of it at which rays are aimed.
struct Target {
  Points points;
  std::vector<OnCurve> places;
};

// For u from -2 to 2, and where it crosses itself, stands still or bends the other way.
const std::array<Target, 3> kSpecials = {{
    {{{-18, 12}, {26, -4}, {-26, -4}, {18, 12}}, {{{0, 3}, {1, 1}}}},  // 3 (u^3 - u), 3 u^2: a loop
    {{{-24, 12}, {24, -4}, {-24, -4}, {24, 12}}, {{{0, 0}, {0, 1}}}},  // 3 u^3, 3 u^2: a cusp
    {{{-6, -24}, {-2, 24}, {2, -24}, {6, 24}}, {{{0, 0}, {1, 0}}}},    // 3 u, 3 u^3: an inflection
}};

// By de Casteljau. At quarters doubles hold it of whole control points.
OnCurve on_curve(Points points, double s) {
  Vec2 tangent(0, 0);
  while (points.size() > 1) {
    if (points.size() == 2) tangent = points[1] - points[0];
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      points[i] = (1 - s) * points[i] + s * points[i + 1];
    points.pop_back();
  }
  return {points[0], tangent};
}

// A special curve turned, reflected, sheared, at a whole point.
Target special_curve(Draw& draw) {
  const Target& special = kSpecials[static_cast<std::size_t>(draw.below(3))];
  const double turn = draw.sign(), flip = draw.sign(), shear = draw.below(5) - 2;
  const Vec2 to = whole_point(draw, 0, kWorld);
  const auto linear = [&](const Vec2& p) {
    const Vec2 q(flip * p.x() + shear * p.y(), p.y());
    return turn > 0 ? q : Vec2(-q.y(), q.x());
  };
  Target target;
  for (const Vec2& p : special.points) target.points.push_back(to + linear(p));
  const OnCurve& place = special.places[0];
  target.places = {{to + linear(place.at), linear(place.tangent)}};
  return target;
}

Target whole_curve(Draw& draw) {
  Target target;
  const std::size_t count = draw.sign() > 0 ? 3 : 4;
  const Vec2 corner = whole_point(draw, 0, kWorld - 8);
  do {
    target.points.clear();
    while (target.points.size() < count) target.points.push_back(corner + whole_point(draw, 0, 9));
  } while (lie_on_one_line(target.points));
  if (count == 3 && draw.sign() > 0) {  // the same parabola as a cubic
    const Points& p = target.points;
    target.points = {3 * p[0], p[0] + 2 * p[1], 2 * p[1] + p[2], 3 * p[2]};
  }
  return target;
}

Target random_curve(Draw& draw) {
  Target target;
  const std::size_t count = draw.sign() > 0 ? 3 : 4;
  while (target.points.size() < count) target.points.push_back(kWorld * any_point(draw));
  return target;
}

// Rays through a place on a curve: along the tangent, at it from anywhere, from it to anywhere, or
// without direction; each half within an ulp of that.
Ray ray_at(const OnCurve& place, Draw& draw) {
  const double kind = draw.below(5), back = draw.below(4), sign = draw.sign();
  const Vec2 other = whole_point(draw, -8, kWorld + 8);
  Ray ray{other, place.at - other};
  if (kind == 0 || kind == 1) ray = {place.at - sign * back * place.tangent, sign * place.tangent};
  if (kind == 3) ray = {place.at, other - place.at};
  if (kind == 4) ray = {place.at, back == 0 ? Vec2(0, 0) : Vec2(sign * place.tangent)};
  if (draw.sign() > 0) return ray;
  const Vec2 origin = nudge(ray.origin, draw);
  return {origin, ray.direction == Vec2(0, 0) ? ray.direction : nudge(ray.direction, draw)};
}

template <class Make>
BezierScene scene_of(Draw& draw, const Make& curve) {
  std::vector<Target> targets;
  BezierScene scene;
  for (int i = 0; i < kCurves; ++i) {
    Target target = curve();
    for (int k = 0; k <= 4; ++k) target.places.push_back(on_curve(target.points, k / 4.0));
    scene.curves.push_back(target.points);
    targets.push_back(std::move(target));
  }
  while (scene.rays.size() < kRaysAScene) {
    const Target& target = targets[static_cast<std::size_t>(draw.below(kCurves))];
    const auto place = static_cast<std::size_t>(draw.below(static_cast<int>(target.places.size())));
    scene.rays.push_back(ray_at(target.places[place], draw));
  }
  return scene;
}

// Every point put through f; rays keep the points they lead to.
template <class Move>
BezierScene mapped(BezierScene scene, const Move& f) {
  for (Points& points : scene.curves)
    for (Vec2& p : points) p = f(p);
  for (Ray& ray : scene.rays) {
    const Vec2 tip = f(ray.origin + ray.direction), origin = f(ray.origin);
    ray = {origin, tip - origin};
  }
  return scene;
}

}  // namespace

BezierScene beziers(Draw& draw) {
  return scene_of(draw, [&] { return draw.sign() > 0 ? special_curve(draw) : whole_curve(draw); });
}
BezierScene bezier_scaled(Draw& draw) {
  const double factor = std::ldexp(1.0, static_cast<int>(draw.below(1800)) - 900);
  return mapped(beziers(draw), [&](const Vec2& v) { return Vec2(v * factor); });
}
BezierScene bezier_offset(Draw& draw) {
  const double x = draw.sign(), size = std::ldexp(1.0, 10 + static_cast<int>(draw.below(20)));
  const Vec2 far(x * size, draw.sign() * size);
  return mapped(beziers(draw), [&](const Vec2& v) { return Vec2(v + far); });
}
BezierScene bezier_sliver(Draw& draw) {
  const double thin = std::ldexp(1.0, -static_cast<int>(draw.below(300)));
  return mapped(beziers(draw), [&](const Vec2& v) { return Vec2(v.x(), v.y() * thin); });
}
BezierScene bezier_random(Draw& draw) {
  return scene_of(draw, [&] { return random_curve(draw); });
}

}  // namespace flatray::oracle
