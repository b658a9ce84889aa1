#include "geom/primitives/arc.h"

#include "geom/decide.h"
#include "geom/error_bounds.h"
#include "geom/primitives/wall.h"

namespace flatray {
namespace {

// Whether a ray surely misses all that is within `reach` of `centre`.
bool surely_missed(const Ray& ray, const Vec2& centre, double reach) {
  const auto time = curve_time(kNear, ray, Circle{centre, reach});
  const auto chord = time.q.sign();
  if (chord == Sign::negative) return true;
  return time.b.sign() == Sign::negative && time.outside.sign() == Sign::positive;
}

// No point of the arc is farther from its centre, joints to its ends included.
double reach_of(const Arc& arc) {
  const Ellipse& curve = arc.curve;
  const auto size = [](const Vec2& v) { return std::fabs(v.x()) + std::fabs(v.y()); };
  double reach = curve.is_circle() ? curve.u.x() : size(curve.u) + size(curve.v);
  if (arc.extent == Arc::Extent::between)
    reach = std::max({reach, size(arc.from - curve.centre), size(arc.to - curve.centre)});
  return reach * (1 + 0x1p-48);
}

// On which side of a curve the box of half sides `reach` about `point` surely lies.
std::optional<Sign> side_of_box(const Ellipse& wall, const Vec2& point, const Vec2& reach) {
  return curve_power(kNear, wall, within(point, reach) - pair_of(kNear, wall.centre)).sign();
}

// Whether what joins an end of an arc to its curve may come into the box: it lies on the line from the
// centre, beyond the curve and not beyond the end, or the other way round.
bool joint_passes_near(const Ellipse& wall, const Vec2& end, const Vec2& point, const Vec2& reach) {
  if (line_passes_far({wall.centre, end}, point, reach)) return false;
  const auto from = within(point, reach) - pair_of(kNear, wall.centre);
  const auto way = pair_of(kNear, end) - pair_of(kNear, wall.centre);
  if (dot(from, way).sign() == Sign::negative) return false;
  const auto beyond_end = dot(from - way, way).sign(),
             beyond_curve = side_of_box(wall, point, reach);
  return !beyond_end || !beyond_curve || *beyond_end != *beyond_curve;
}

// Whether an arc surely ends before it comes into the box: on the outer side of one end's line and
// far from it, where the arc is less than a half turn.
bool ends_before(const Arc& arc, const Vec2& point, const Vec2& reach) {
  const Vec2& centre = arc.curve.centre;
  if (arc.extent == Arc::Extent::whole) return false;
  if (arc.extent == Arc::Extent::half)
    return line_passes_far({Vec2(0, 0), Vec2(arc.from.y(), -arc.from.x())}, point - centre,
                           reach) &&
           arc.from.dot(point - centre) < 0;
  if (orientation(centre, arc.from, arc.to) == Sign::negative) return false;
  const Segment from{centre, arc.from}, to{arc.to, centre};
  for (const Segment& end : {from, to})
    if (line_passes_far(end, point, reach) && orientation(end.a, end.b, point) == Sign::negative)
      return true;
  return false;
}

// Where a tangent touches: the middle between two roots that are one.
Vec2 touched(const Ray& ray, const Ellipse& curve) {
  return round_both([&](const auto& number) {
    const auto o = pair_of(number, ray.origin), along = pair_of(number, ray.direction);
    const auto d = curve_form(number, curve, along);
    const auto w = curve_form(number, curve, pair_of(number, curve.centre) - o);
    return o + (dot(w, d) / dot(d, d)) * along;
  });
}

// A direction, from one point to another.
struct Way {
  Vec2 from, to;
};
Sign turn(const Way& a, const Way& b) { return cross_sign(a.from, a.to, b.from, b.to); }

// The directions in which an arc that is not whole starts and ends, counter-clockwise about its centre.
std::array<Way, 2> ways_of_ends(const Arc& arc) {
  const Vec2 start(arc.from.y(), -arc.from.x()), zero(0, 0);
  if (arc.extent == Arc::Extent::half) return {Way{zero, start}, Way{start, zero}};
  return {Way{arc.curve.centre, arc.from}, Way{arc.curve.centre, arc.to}};
}

// Whether a direction is met on the way counter-clockwise from one to another, without these.
bool is_within(const Way& way, const Way& from, const Way& to) {
  const bool past_from = turn(from, way) == Sign::positive,
             before_to = turn(way, to) == Sign::positive;
  const Sign whole = turn(from, to);
  return whole == Sign::negative ? past_from || before_to
                                 : past_from && (before_to || whole == Sign::zero);
}

bool is_same(const Way& a, const Way& b) {
  const auto heads = [](const Way& way, int axis) {
    return (way.to[axis] > way.from[axis]) - (way.to[axis] < way.from[axis]);
  };
  return turn(a, b) == Sign::zero && heads(a, 0) == heads(b, 0) && heads(a, 1) == heads(b, 1);
}

}  // namespace

Sign curve_side(const Vec2& point, const Ellipse& curve) {
  return decide([&](const auto& number) {
    return curve_power(number, curve, pair_of(number, point) - pair_of(number, curve.centre));
  });
}

// By their centres and by u u' + v v', which no change of conjugate half-diameters moves.
bool is_same_curve(const Ellipse& a, const Ellipse& b) {
  if (a.centre != b.centre) return false;
  const auto is_same = [&](int i, int j) {
    return decide([&](const auto& number) {
             const auto form = [&](const Ellipse& curve) {
               return number(curve.u[i]) * number(curve.u[j]) +
                      number(curve.v[i]) * number(curve.v[j]);
             };
             return form(a) - form(b);
           }) == Sign::zero;
  };
  return (a.u == b.u && a.v == b.v) || (is_same(0, 0) && is_same(0, 1) && is_same(1, 1));
}

// From the end e on, towards the curve and no farther. Sides are asked last: an end is so near to the curve
// that filters do not tell.
bool is_on_joint(const Ellipse& curve, const Vec2& end, const Vec2& point) {
  const Vec2& centre = curve.centre;
  if (orientation(centre, end, point) != Sign::zero) return false;
  const auto ahead_of = [&](const Vec2& from) {
    return decide([&](const auto& number) {
      return dot(pair_of(number, point) - pair_of(number, from),
                 pair_of(number, end) - pair_of(number, centre));
    });
  };
  if (ahead_of(centre) != Sign::positive) return false;
  const Sign side = curve_side(end, curve);
  return side != Sign::zero && curve_side(point, curve) == side && ahead_of(end) != side;
}

bool is_on_joints(const Arc& arc, const Vec2& point) {
  return arc.extent == Arc::Extent::between &&
         (is_on_joint(arc.curve, arc.from, point) || is_on_joint(arc.curve, arc.to, point));
}

PlaceOn place_on(const Arc& arc, const Vec2& point) {
  if (curve_side(point, arc.curve) == Sign::zero) return place_in_cone(arc, point);
  return is_on_joints(arc, point) ? PlaceOn::at_end : PlaceOn::outside;
}

HalfAxes half_axes(const Ellipse& curve) {
  if (curve.is_circle()) return {curve.u.x(), curve.u.x()};
  const double most = std::sqrt(curve.u.squaredNorm() + curve.v.squaredNorm());
  return {(curve.u.x() * curve.v.y() - curve.u.y() * curve.v.x()) / most, most};
}

// The reach along an axis is sqrt(u_i^2 + v_i^2), below |u_i| + |v_i|, neither of which overflows
// before the other by more than a factor of 2; four roundings, and one of the sum with the centre.
Bounds curve_bounds(const Ellipse& curve) {
  constexpr double kUp = 1 + 0x1p-49;
  Bounds box;
  for (int axis = 0; axis < 2; ++axis) {
    const double a = std::fabs(curve.u[axis]), b = std::fabs(curve.v[axis]);
    const double larger = std::max(a, b), ratio = larger == 0 ? 0 : std::min(a, b) / larger;
    const double reach = larger * std::sqrt(1 + ratio * ratio) * kUp + 0x1p-1070;
    const double most = std::numeric_limits<double>::max();
    box.low[axis] = std::max(std::nextafter(curve.centre[axis] - reach, -kInfinity), -most);
    box.high[axis] = std::min(std::nextafter(curve.centre[axis] + reach, kInfinity), most);
  }
  return box;
}

Bounds bounds_of(const Arc& wall) {
  Bounds box = curve_bounds(wall.curve);
  if (wall.extent == Arc::Extent::between) {
    box.add(wall.from);
    box.add(wall.to);
  }
  return box;
}

bool passes_near(const Arc& wall, const Vec2& point, const Vec2& reach) {
  if (!side_of_box(wall.curve, point, reach) && !ends_before(wall, point, reach)) return true;
  return wall.extent == Arc::Extent::between &&
         (joint_passes_near(wall.curve, wall.from, point, reach) ||
          joint_passes_near(wall.curve, wall.to, point, reach));
}

namespace {

// When a ray meets what joins an end of an arc to its curve.
std::optional<HitTime> joint_met(const Arc& arc, const Ray& ray, const Vec2& end) {
  if (is_on_joint(arc.curve, end, ray.origin)) return HitTime::abreast(ray, ray.origin);
  const auto time = hit_joint(ray, arc.curve, end);
  return time && time->sign() != Sign::negative ? time : std::nullopt;
}

}  // namespace

void meet(const Arc& wall, const Ray& ray, const MeetingRules& rules,
          std::vector<WallMeeting>& met) {
  if (surely_missed(ray, wall.curve.centre, reach_of(wall))) return;
  const bool whole = wall.extent == Arc::Extent::whole;
  if (wall.extent == Arc::Extent::between)
    for (const Vec2& end : {wall.from, wall.to})
      if (const auto time = joint_met(wall, ray, end))
        met.push_back({*time, HitClass::touch, Root::none, true});
  if (rules.stood_on == Root::both) return;
  const auto hit = hit_curve(ray, wall.curve);
  if (!hit) return;
  const auto add = [&](const HitTime& time, HitClass kind, Root root, bool inner) {
    const PlaceOn place = whole ? PlaceOn::inner : ExactHit(ray, wall, root).place_in(wall);
    const bool is_met = place == PlaceOn::at_end || (inner && place == PlaceOn::inner);
    if (is_met) met.push_back({time, kind, root, place == PlaceOn::at_end});
    return is_met;
  };
  if (hit->tangent) {
    const bool passed_by = !rules.tangents && whole;
    if (!passed_by && rules.stood_on == Root::none && hit->first.sign() != Sign::negative)
      add(hit->first, HitClass::touch, Root::both, rules.tangents);
    return;
  }
  for (const Root root : {Root::first, Root::second}) {
    const HitTime& time = root == Root::first ? hit->first : hit->second;
    if (rules.stood_on == root || time.sign() == Sign::negative) continue;
    if (add(time, HitClass::through, root, true) && !rules.every) return;
  }
}

bool is_crossed(const Arc& wall, const Ray& ray) {
  const auto hit = hit_curve(ray, wall.curve);
  return hit && !hit->tangent;
}

namespace {

// The end of an arc that a ray arrives at, or by whose joint it does; of two at the same time the first.
Vec2 end_arrived_at(const Arc& arc, const Ray& ray, Root root) {
  const Vec2& centre = arc.curve.centre;
  if (root == Root::none) {
    const auto from = joint_met(arc, ray, arc.from), to = joint_met(arc, ray, arc.to);
    return from && (!to || compare(*from, *to) <= 0) ? arc.from : arc.to;
  }
  const ExactHit exact(ray, arc, root);
  const bool at_from = exact.turn(centre, centre, arc.from) == Sign::zero;
  const bool at_to = exact.turn(centre, centre, arc.to) == Sign::zero;
  if (at_from != at_to) return at_from ? arc.from : arc.to;
  // Of a half turn: the ends lie opposite, and the arc is on the left of the line from `from`.
  return exact.ahead(centre, centre, arc.from) == Sign::positive ? arc.from : arc.to;
}

// Whether an end stands for a point of its joint, as one that rounding moved off the curve does.
bool stands_for(const Vec2& end, const Vec2& point) {
  return (end - point).cwiseAbs().maxCoeff() <= 0x1p-50 * point.cwiseAbs().maxCoeff();
}

}  // namespace

std::optional<ExactHit> exact_end(const Arc& wall, const Ray& ray, Root root) {
  if (is_zero(ray.direction)) return std::nullopt;
  if (root != Root::none) return ExactHit(ray, wall, root);
  if (is_on_joints(wall, ray.origin)) return std::nullopt;
  const Segment line{wall.curve.centre, end_arrived_at(wall, ray, root)};
  return is_crossed(line, ray) ? std::optional(ExactHit(ray, line)) : std::nullopt;
}

Vec2 end_met(const Arc& arc, const Ray& ray, Root root) {
  if (root == Root::none && is_on_joints(arc, ray.origin)) return ray.origin;
  const auto exact = exact_end(arc, ray, root);
  if (exact && arc.extent == Arc::Extent::half) return exact->nearest();
  Vec2 point = end_arrived_at(arc, ray, root);
  if (!exact) return point;
  if (const Vec2 nearest = exact->nearest(); !stands_for(point, nearest)) point = nearest;
  return point;
}

Vec2 point_met(const Arc& wall, const Ray& ray, Root root) {
  return root == Root::both ? touched(ray, wall.curve) : ExactHit(ray, wall, root).nearest();
}

bool leads_away(const Arc& wall, Sign side, const Ray& ray) {
  const Ellipse& curve = wall.curve;
  return side == decide([&](const auto& number) {
           const auto from = pair_of(number, ray.origin) - pair_of(number, curve.centre);
           return dot(curve_form(number, curve, from),
                      curve_form(number, curve, pair_of(number, ray.direction)));
         });
}

Vec2 normal_near(const Arc& wall, const Vec2& point) {
  const auto form =
      curve_form(kPlain, wall.curve, pair_of(kPlain, Vec2(point - wall.curve.centre)));
  const auto normal = curve_normal(kPlain, wall.curve, form);
  return {normal.x, normal.y};
}

// Two cones have directions in common where one starts within the other, or both start together.
bool overlap(const Arc& one, const Arc& other) {
  const bool is_point = one.curve.u == Vec2(0, 0) && one.curve.v == Vec2(0, 0);
  if (is_point || !is_same_curve(one.curve, other.curve)) return false;
  if (one.extent == Arc::Extent::whole || other.extent == Arc::Extent::whole) return true;
  const auto [from, to] = ways_of_ends(one);
  const auto [other_from, other_to] = ways_of_ends(other);
  return is_same(from, other_from) || is_within(from, other_from, other_to) ||
         is_within(other_from, from, to);
}

// The arc, its joints with it, and the lines from its ends to the centre enclose a piece of the cone. A
// point on such a line counts as one to the right of it and above, by less than anything.
bool crosses_to_right(const Arc& wall, const Vec2& point) {
  const bool within = side_of(wall, point) == Sign::negative;
  if (wall.extent == Arc::Extent::whole) return within;
  const Vec2& centre = wall.curve.centre;
  const auto left_of = [&](const Vec2& end) {
    const Sign side = orientation(centre, end, point);
    if (side != Sign::zero) return side == Sign::positive;
    return end.y() != centre.y() ? end.y() < centre.y() : end.x() > centre.x();
  };
  const bool past_from = left_of(wall.from), before_to = !left_of(wall.to);
  const bool in_cone = orientation(centre, wall.from, wall.to) == Sign::negative
                           ? past_from || before_to
                           : past_from && before_to;
  return (within && in_cone) != (crosses_to_right(Segment{centre, wall.from}, point) !=
                                 crosses_to_right(Segment{wall.to, centre}, point));
}

}  // namespace flatray
