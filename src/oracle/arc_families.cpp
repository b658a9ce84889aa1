#include "oracle/families.h"

namespace flatray::oracle {
namespace {

using Scene = AimedScene;
constexpr int kCurves = 12;

// Legs and hypotenuse in whole numbers: points of circles about whole numbers that doubles hold.
constexpr struct {
  int x, y, radius;
} kTriples[] = {{1, 0, 1}, {3, 4, 5}, {4, 3, 5}, {5, 12, 13}, {15, 8, 17}, {7, 24, 25}};

// A direction of whole numbers whose length is one, too.
struct Spoke {
  Vec2 to;
  double length;
};
Spoke spoke(Draw& draw) {
  const auto& triple = draw.any(kTriples);
  const double x = draw.sign() * triple.x, y = draw.sign() * triple.y;
  return {draw.sign() < 0 ? Vec2(x, y) : Vec2(y, x), static_cast<double>(triple.radius)};
}
Vec2 quarter(const Vec2& v) { return {-v.y(), v.x()}; }
Vec2 whole_point(Draw& draw) { return draw.whole_point(0, kWorld); }
// On the unit circle but for rounding, by a fraction: no sines, whose last bits differ.
Vec2 unit_vector(Draw& draw) {
  const double h = 2 * draw.unit() - 1, sign = draw.sign();
  return sign * Vec2(1 - h * h, 2 * h) / (1 + h * h);
}

Arc whole(const Ellipse& curve) { return {curve, Arc::Extent::whole, {0, 0}, {0, 0}}; }

// Of curves drawn one by one.
template <Arc (*make)(Draw&)>
Scene curves(Draw& draw) {
  Scene scene;
  for (int i = 0; i < kCurves; ++i) scene.curves.push_back(make(draw));
  return scene;
}

// Circles about whole numbers that touch, repeat and hold each other, with chords and spokes.
Scene whole_circles(Draw& draw) {
  Scene scene;
  scene.curves_first = draw.sign() > 0;
  while (scene.curves.size() < kCurves) {
    const Vec2 centre = whole_point(draw);
    const Spoke out = spoke(draw), other = spoke(draw);
    const double times = 1 + draw.below(3);
    scene.curves.push_back(whole(Circle{centre, times * out.length}));
    if (draw.below(3) == 0)
      scene.curves.push_back(whole(Circle{centre + 2 * times * out.to, times * out.length}));
    const Vec2 from = centre + times * out.to;
    const double kind = draw.below(3);
    const Vec2 to = kind == 0   ? centre
                    : kind == 1 ? Vec2(from + quarter(out.to))
                                : Vec2(centre + times * other.to);
    scene.walls.push_back({from, to});
  }
  return scene;
}

// Through a whole point of a circle, or one near its centre: along the tangent or a spoke,
// from the point, from before it, or from another whole point.
Ray at_whole_circle(const Scene& scene, Draw& draw) {
  const Ellipse& circle = draw.any(scene.curves).curve;
  const Spoke out = spoke(draw);
  const double any = draw.below(4), back = draw.below(4), fits = circle.u.x() / out.length;
  const Vec2 at = circle.centre + (fits == std::floor(fits) ? fits : any) * out.to;
  const double kind = draw.below(4), sign = draw.sign();
  if (kind == 3) {
    const Vec2 from = whole_point(draw);
    return {from, at - from};
  }
  const Vec2 way = kind == 0 ? out.to : quarter(out.to);
  return {at - sign * back * way, kind == 2 ? Vec2(0, 0) : Vec2(sign * way)};
}

Arc random_circle(Draw& draw) {
  const Vec2 centre = draw.point();
  return whole(Circle{centre, 0.3 * draw.unit()});
}

OnCurve on_curve(const Ellipse& curve, Draw& draw) {
  const Vec2 unit = unit_vector(draw);
  return {curve.centre + unit.x() * curve.u + unit.y() * curve.v,
          unit.x() * curve.v - unit.y() * curve.u};
}

Ray tangent_ray(const Scene& scene, Draw& draw) {
  const OnCurve place = on_curve(draw.any(scene.curves).curve, draw);
  const double back = 4 * draw.unit();
  const Vec2 origin = nudge(Vec2(place.at - back * place.tangent), draw);
  return {origin, nudge(Vec2(place.at - origin), draw)};
}

// From a point of a curve, but for rounding, or an ulp off it: along the tangent, to the centre,
// away from it, anywhere.
Ray ray_from_curve(const Scene& scene, Draw& draw) {
  const Ellipse& curve = draw.any(scene.curves).curve;
  const OnCurve place = on_curve(curve, draw);
  const Vec2 origin = nudge(place.at, draw), to_centre = curve.centre - origin;
  const double kind = draw.below(4), sign = draw.sign();
  const Vec2 other = draw.point();
  const Vec2 way = kind == 0 ? place.tangent : kind == 3 ? other : to_centre;
  return {origin, sign * way};
}

Arc part_of(const Ellipse& curve, const Vec2& from, const Vec2& to, Draw& draw) {
  const double kind = draw.below(4);
  if (kind == 0) return {curve, Arc::Extent::half, from - curve.centre, {0, 0}};
  return {curve, Arc::Extent::between, from, to};
}

// Arcs of circles that end exactly on them, next to them, or far off.
Arc any_arc(Draw& draw) {
  const Vec2 centre = whole_point(draw);
  if (draw.sign() > 0) {
    const double x = 5 * draw.sign(), y = 3 * draw.sign(), times = 1 + draw.below(2);
    const auto off = [&] {
      const double kind = draw.below(4);
      return kind == 0 ? 2 : kind == 1 ? 0.5 : 1;
    };
    const Vec2 from = centre + off() * times * Vec2(x, 0), to = centre + off() * times * Vec2(4, y);
    return part_of(Circle{centre, times * 5}, from, to, draw);
  }
  const Circle circle{centre, 6 * draw.unit() + 0.5};
  const OnCurve from = on_curve(circle, draw), to = on_curve(circle, draw);
  return part_of(circle, from.at, to.at, draw);
}

Ray at_arc_end(const Scene& scene, Draw& draw) {
  const Arc& arc = draw.any(scene.curves);
  const bool half = arc.extent == Arc::Extent::half;
  const Vec2 centre = arc.curve.centre;
  const Vec2 of_half = centre + arc.curve.u.x() / arc.from.norm() * quarter(arc.from);
  const Vec2 end = half ? of_half : draw.sign() > 0 ? arc.from : arc.to;
  const double kind = draw.below(5);
  const Vec2 at = draw.sign() > 0 ? nudge(end, draw) : end;
  if (kind == 0) return {at, {0, 0}};
  if (kind == 1) return {centre, at - centre};
  const Vec2 from = kind == 2 ? Vec2(2 * at - centre) : whole_point(draw);
  return {from, at - from};
}

// Half-diameters of whole numbers, at right angles or not; random ones; parts of them.
Arc any_ellipse(Draw& draw) {
  const double kind = draw.below(3);
  if (kind == 0) {
    const Vec2 centre = whole_point(draw), u{1 + draw.below(5), draw.below(4)};
    const Vec2 v{-draw.below(4), 1 + draw.below(5)};
    const Ellipse curve(centre, u, v);
    return draw.sign() > 0 ? whole(curve) : part_of(curve, centre + u, centre + v, draw);
  }
  const double size = kind == 1 ? 6 : 4, thin = draw.halves(20);
  const Vec2 centre = kWorld * draw.point(), u = size * unit_vector(draw);
  const Vec2 v = thin * (quarter(u) + 0.5 * draw.point());
  const Ellipse curve(centre, u, draw.sign() * v);
  if (kind == 1) return whole(curve);
  const OnCurve from = on_curve(curve, draw), to = on_curve(curve, draw);
  return part_of(curve, from.at, to.at, draw);
}

Ray at_ellipse(const Scene& scene, Draw& draw) {
  const double kind = draw.below(4);
  if (kind == 0) return tangent_ray(scene, draw);
  if (kind == 1) return ray_from_curve(scene, draw);
  const Ellipse& curve = draw.any(scene.curves).curve;
  const Vec2 from = whole_point(draw), centre = curve.centre;
  const Vec2 at = kind == 2 ? centre : Vec2(centre + draw.sign() * curve.u);
  return {from, at - from};
}

// All kinds of rays at circles and arcs.
Scene circles_and_arcs(Draw& draw) {
  Scene scene = whole_circles(draw);
  for (int i = 0; i < kCurves / 2; ++i) scene.curves.push_back(any_arc(draw));
  return scene;
}
Ray at_any_circle(const Scene& scene, Draw& draw) {
  const double kind = draw.below(3);
  return kind == 0   ? at_whole_circle(scene, draw)
         : kind == 1 ? tangent_ray(scene, draw)
                     : ray_from_curve(scene, draw);
}

Scene arcs_with_chords(Draw& draw) {
  Scene scene = curves<any_arc>(draw);
  for (const Arc& arc : scene.curves)
    if (arc.extent == Arc::Extent::between) scene.walls.push_back({arc.to, arc.from});
  return scene;
}

// Radii and distances from 2^-50 to 2^49 beside each other, about one point.
Arc circle_of_any_size(Draw& draw) {
  const Vec2 place = draw.point();
  const double size = draw.power(-50, 50), radius = size * (0.5 + draw.unit());
  return whole(Circle{draw.power(-50, 50) * place, radius});
}
Ray tangent_or_from_curve(const Scene& scene, Draw& draw) {
  return draw.sign() > 0 ? tangent_ray(scene, draw) : ray_from_curve(scene, draw);
}

// Circles of no radius, of a tiny one and of one far larger than the scene, which no cells hold; nearly whole
// turns; halves whose direction is so short that its square is denormal or 0; parts whose ends lie off their curve.
Arc arc_of_any_kind(Draw& draw) {
  const Vec2 at = whole_point(draw), way = spoke(draw).to;
  switch (draw.whole(0, 8)) {
    case 0:
      return whole(Circle{at, 0});
    case 1:
      return whole(Circle{at, draw.power(-1060, -40)});
    case 2: {
      const double large = draw.power(0, 900);
      return whole(Circle{at + large * way, large * way.norm()});
    }
    case 3: {
      const Vec2 centre = draw.sign() > 0 ? at : Vec2(kWorld * draw.point());
      const Circle circle{centre, 5 * draw.unit()};
      const Vec2 from = on_curve(circle, draw).at;
      return part_of(circle, from, nudge(from, draw), draw);
    }
    case 4:
      return {Circle{at, 5}, Arc::Extent::half, draw.power(-560, -500) * way, {0, 0}};
    case 5: {
      const double off = draw.power(-45, 3);
      const Vec2 to = at + way.norm() * unit_vector(draw);
      return part_of(Circle{at, way.norm()}, at + way, to + off * unit_vector(draw), draw);
    }
    case 6:
      return any_ellipse(draw);
    default:
      return any_arc(draw);
  }
}

Scene mixed_curves(Draw& draw) {
  Scene scene = curves<arc_of_any_kind>(draw);
  scene.curves_first = draw.sign() > 0;
  while (scene.walls.size() < 3 * kCurves) {
    const Vec2 from = whole_point(draw);
    scene.walls.push_back({from, from + draw.whole_point(-1, 2)});
  }
  return scene;
}

// Where a curve ends, or any way out from its centre.
Vec2 way_out(const Arc& arc, Draw& draw) {
  if (arc.extent == Arc::Extent::between) return arc.to - arc.curve.centre;
  if (arc.extent == Arc::Extent::whole) return spoke(draw).to;
  return quarter(arc.from / arc.from.cwiseAbs().maxCoeff());
}

// Half of them from or at a point on that way: where it leads to, about where it meets the curve, or between, where
// a part whose end lies off its curve has the line that joins them.
Ray at_mixed_curve(const Scene& scene, Draw& draw) {
  const double kind = draw.below(5);
  if (kind == 0) return at_ellipse(scene, draw);
  if (kind == 1) return at_arc_end(scene, draw);
  const Arc& arc = draw.any(scene.curves);
  const Vec2 out = way_out(arc, draw), other = whole_point(draw);
  const double choice = draw.below(3), share = choice == 2 ? draw.unit() : choice;
  const double reach = arc.curve.u.norm() / out.norm();
  const Vec2 at = arc.curve.centre + (share + (1 - share) * reach) * out;
  if (kind == 2) return {at, draw.sign() * out};
  return kind == 3 ? Ray{at, spoke(draw).to} : Ray{other, at - other};
}

// Squares and quotients of what is tiny or large are not finite.
Ray at_mixed_curves(const Scene& scene, Draw& draw) {
  Ray ray = at_mixed_curve(scene, draw);
  if ((ray.origin + ray.direction).allFinite()) return ray;
  const Vec2 from = whole_point(draw);
  return {from, whole_point(draw) - from};
}

Vec2 either_way(const Vec2& v, Draw& draw) { return draw.sign() > 0 ? v : Vec2(v.y(), v.x()); }

// In a box about the origin, so that cells meet along both axes: walls and thin ellipses that stay close to an axis
// and cross it, beside others, which in half of the scenes crowd about the origin.
Scene along_the_axes(Draw& draw) {
  constexpr double kHalf = 8;
  Scene scene;
  for (const double side : {-kHalf, kHalf}) scene.walls.push_back({{-kHalf, side}, {kHalf, side}});
  scene.curves.push_back({Circle{{0, 0}, kHalf}, Arc::Extent::whole, {0, 0}, {0, 0}});
  const double size = draw.sign() > 0 ? 1 : 0x1p-6;
  while (scene.walls.size() < 20) {
    const Vec2 end = either_way({kHalf, draw.signed_halves(20)}, draw);
    const Vec2 from = draw.whole_point(-8, 9);
    scene.walls.push_back(draw.sign() > 0 ? Segment{-end, end}
                                          : Segment{from, draw.whole_point(-8, 9)});
  }
  while (scene.curves.size() < 40) {
    const Vec2 centre = draw.whole_point(-5, 6);
    const double length = draw.whole(1, 4);
    const Vec2 along = either_way({length, draw.signed_halves(20)}, draw);
    const Ellipse thin{either_way({centre.x(), 0}, draw), along, draw.halves(20) * quarter(along)};
    const Ellipse round = Circle{size * centre, 0.25 * size * draw.whole(1, 8)};
    scene.curves.push_back({draw.below(4) == 0 ? thin : round, Arc::Extent::whole, {0, 0}, {0, 0}});
  }
  return scene;
}

// Most of them towards the axis.
Ray along_an_axis(const Scene&, Draw& draw) {
  const double aside = draw.signed_halves(60), from = draw.below(256) / 16 - 8;
  const double along = draw.sign(), away = draw.below(4) == 0 ? 1 : -1;
  const double tilt = std::copysign(draw.halves(60), away * aside);
  if (draw.sign() > 0) return {{from, aside}, {along, tilt}};
  return {{aside, from}, {tilt, along}};
}

Move arcs_far_away(Draw& draw) {
  const double sign = draw.sign(), x = sign * draw.power(30, 50);
  return moved_by({x, x * draw.sign()});
}

}  // namespace

std::vector<Family> arc_families() {
  return {
      {"circles", "circles about whole numbers, tangents and chords through whole points",
       &whole_circles, &at_whole_circle},
      {"tangents", "rays within an ulp of tangents of circles", &curves<random_circle>,
       &tangent_ray},
      {"from-circles", "rays from circles, or an ulp off them: along, inward, outward",
       &curves<random_circle>, &ray_from_curve},
      {"arc-ends", "rays at ends of arcs on their circle, next to it and far off",
       &arcs_with_chords, &at_arc_end},
      {"ellipses", "ellipses and parts of them, flattened by up to 2^-19", &curves<any_ellipse>,
       &at_ellipse},
      {"round-scaled", "circles and arcs in units of 2^-900 to 2^899", &circles_and_arcs,
       &at_any_circle, &scaled},
      {"round-offset", "circles and arcs moved by 2^30 to 2^49", &circles_and_arcs, &at_any_circle,
       &arcs_far_away},
      {"round-magnitudes", "circles of radius and distance 2^-50 to 2^49",
       &curves<circle_of_any_size>, &tangent_or_from_curve},
  };
}

std::vector<Family> mixed_families() {
  return {{"round-mixed",
           "segments beside circles and ellipses of no size and any, and parts of all kinds",
           &mixed_curves, &at_mixed_curves},
          {"axes",
           "rays along axes where cells meet, but for up to 2^-59, among what stays close to these",
           &along_the_axes, &along_an_axis}};
}

}  // namespace flatray::oracle
