#include <algorithm>
#include <array>

#include "oracle/families.h"

namespace flatray::oracle {
namespace {

using Points = std::vector<Vec2>;
constexpr int kBeziers = 8;

bool lie_on_one_line(const Points& points) {
  const Vec2 way = *std::find_if(points.begin(), points.end() - 1, [&](const Vec2& p) {
    return p != points[0];
  }) - points[0];
  return std::all_of(points.begin(), points.end(), [&](const Vec2& p) {
    return way.x() * (p - points[0]).y() == way.y() * (p - points[0]).x();
  });
}

// A curve and points of it at which rays are aimed.
struct Target {
  Points points;
  std::vector<OnCurve> places;
  double weight = 1;
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
  const Target& special = draw.any(kSpecials);
  const double turn = draw.sign(), flip = draw.sign(), shear = draw.below(5) - 2;
  const Vec2 to = draw.whole_point(0, kWorld);
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
  const Vec2 corner = draw.whole_point(0, kWorld - 8);
  do {
    target.points.clear();
    while (target.points.size() < count) target.points.push_back(corner + draw.whole_point(0, 9));
  } while (lie_on_one_line(target.points));
  if (count == 3 && draw.sign() > 0) {  // the same parabola as a cubic
    const Points& p = target.points;
    target.points = {3 * p[0], p[0] + 2 * p[1], 2 * p[1] + p[2], 3 * p[2]};
  }
  return target;
}

Target special_or_whole_curve(Draw& draw) {
  return draw.sign() > 0 ? special_curve(draw) : whole_curve(draw);
}

Target random_curve(Draw& draw) {
  Target target;
  const std::size_t count = draw.sign() > 0 ? 3 : 4;
  while (target.points.size() < count) target.points.push_back(kWorld * draw.point());
  return target;
}

// Conics that have a whole point halfway, where they run along their chords: of points in units of 2 + 2 w.
Target whole_conic(Draw& draw) {
  static constexpr std::array kWeights = {0.5, 1.5, 2.0, 3.0};
  Target target;
  target.weight = draw.any(kWeights);
  const double unit = 2 + 2 * target.weight;
  Points p;
  do {
    p.clear();
    while (p.size() < 3) p.push_back(draw.whole_point(-3, 4));
  } while (lie_on_one_line(p));
  const Vec2 to = draw.whole_point(0, kWorld);
  for (const Vec2& each : p) target.points.push_back(to + unit * each);
  target.places = {{target.points[0], p[1] - p[0]},
                   {to + p[0] + 2 * target.weight * p[1] + p[2], p[2] - p[0]},
                   {target.points[2], p[2] - p[1]}};
  return target;
}

Target random_conic(Draw& draw) {
  Target target;
  while (target.points.size() < 3) target.points.push_back(kWorld * draw.point());
  target.weight = draw.power(-6, 6) * (1 + draw.unit());
  const Points& p = target.points;
  const Vec2 middle = (p[0] + 2 * target.weight * p[1] + p[2]) / (2 + 2 * target.weight);
  target.places = {{p[0], p[1] - p[0]}, {middle, p[2] - p[0]}, {p[2], p[2] - p[1]}};
  return target;
}

// Rays through a place on a curve: along the tangent, at it from anywhere, from it to anywhere, or
// without direction; each half within an ulp of that.
Ray ray_at(const AimedScene& scene, Draw& draw) {
  const OnCurve& place = draw.any(draw.any(scene.places));
  const double kind = draw.below(5), back = draw.below(4), sign = draw.sign();
  const Vec2 other = draw.whole_point(-8, kWorld + 8);
  Ray ray{other, place.at - other};
  if (kind == 0 || kind == 1) ray = {place.at - sign * back * place.tangent, sign * place.tangent};
  if (kind == 3) ray = {place.at, other - place.at};
  if (kind == 4) ray = {place.at, back == 0 ? Vec2(0, 0) : Vec2(sign * place.tangent)};
  if (draw.sign() > 0) return ray;
  const Vec2 origin = nudge(ray.origin, draw);
  return {origin, ray.direction == Vec2(0, 0) ? ray.direction : nudge(ray.direction, draw)};
}

template <Target (*make)(Draw&)>
AimedScene curves(Draw& draw) {
  AimedScene scene;
  for (int i = 0; i < kBeziers; ++i) {
    Target target = make(draw);
    Bezier curve(target.points);
    curve.weight = target.weight;
    if (!curve.is_weighted())
      for (int k = 0; k <= 4; ++k) target.places.push_back(on_curve(target.points, k / 4.0));
    scene.beziers.push_back(curve);
    scene.places.push_back(std::move(target.places));
  }
  return scene;
}

Move bezier_far_away(Draw& draw) {
  const double x = draw.sign(), size = draw.power(10, 30);
  return moved_by({x * size, draw.sign() * size});
}
Move thin_bezier(Draw& draw) { return flattened(draw.halves(300)); }

}  // namespace

std::vector<Family> bezier_families() {
  return {
      {"beziers", "loops, cusps and inflections that doubles hold, and tangents there",
       &curves<special_or_whole_curve>, &ray_at},
      {"bezier-scaled", "Bezier curves in units of 2^-900 to 2^899",
       &curves<special_or_whole_curve>, &ray_at, &scaled},
      {"bezier-offset", "Bezier curves moved by 2^10 to 2^29", &curves<special_or_whole_curve>,
       &ray_at, &bezier_far_away},
      {"bezier-sliver", "Bezier curves flattened by up to 2^-299", &curves<special_or_whole_curve>,
       &ray_at, &thin_bezier},
      {"bezier-random", "Bezier curves of random doubles", &curves<random_curve>, &ray_at},
      {"conics", "parts of ellipses and hyperbolas, and tangents that doubles hold",
       &curves<whole_conic>, &ray_at},
      {"conic-scaled", "the same in units of 2^-900 to 2^899", &curves<whole_conic>, &ray_at,
       &scaled},
      {"conic-sliver", "the same flattened by up to 2^-299", &curves<whole_conic>, &ray_at,
       &thin_bezier},
      {"conic-random", "parts of ellipses and hyperbolas of random doubles", &curves<random_conic>,
       &ray_at},
  };
}

}  // namespace flatray::oracle
