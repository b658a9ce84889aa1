#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "geom/decide.h"
#include "geom/pair.h"
#include "geom/primitives/arc.h"
#include "geom/primitives/bezier_roots.h"
#include "geom/ray.h"

namespace flatray {

/// Whether a line meets a wall.
enum class Met : std::uint8_t { no, between, end, open };

/// What of a wall it meets: of two walls on one line or curve the same part is one point.
enum class WallPart : std::uint8_t { other, line, first_root, second_root, joint };

template <class Number>
struct CourseHit {
  Met met;
  std::optional<Number> place{};  ///< nullopt where it is open and may be anywhere
  WallPart part = WallPart::other;
  std::optional<Vec2> end{};          ///< of an arc, where it is met there
  std::uint32_t surface{};            ///< of the wall, for who knows it
  std::optional<Number> parameter{};  ///< of the point of a Bezier curve
};

/// A line x: (x - about) cross d = m, on which places count by (x - about).d, and one of them is where
/// a ray is. Of a point of a wall just left, or of its centre, the side and the place are then known as
/// they were, so that their errors do not grow from bounce to bounce.
///
/// Needs   Number and make as in Flight.
/// Gives   what is told is true, whatever the arithmetic.
template <class Number, class Make>
struct Course {
  Course(const Ray& start, const Make& make_)
      : make(make_),
        about(start.origin),
        direction(pair(start.direction)),
        moment(make(0)),
        here(make(0)),
        size(dot(direction, direction)) {}

  Make make;
  Vec2 about;
  Pair<Number> direction;
  Number moment, here;
  Number size;                       ///< d.d, which no mirror changes
  std::optional<Number> stood_at{};  ///< the parameter of the Bezier curve just left

  Pair<Number> pair(const Vec2& v) const { return pair_of(make, v); }

  // The line and the ray, moved.
  void move(const Pair<Number>& by) {
    moment = moment + cross(by, direction);
    here = here + dot(by, direction);
  }

  // As seen from `about`.
  Pair<Number> seen(const Vec2& point) const { return pair(point) - pair(about); }

  // On which side of the line a point lies: d cross (point - x), that is (x - point) cross d.
  Number side_of(const Vec2& point) const {
    return point == about ? moment : cross(direction, seen(point)) + moment;
  }
  Number place_of(const Vec2& point) const { return dot(seen(point), direction); }

  /// The line and the ray in plain doubles.
  struct Plain {
    Vec2 about;
    Pair<Near> direction;
    Near moment, here;

    /// Whether all of a box is surely to one side of the line, or behind the ray.
    bool passes(const Pair<Near>& box) const {
      const Pair<Near> seen = box - pair_of(kNear, about);
      const Sign side = (cross(direction, seen) + moment).sign().value_or(Sign::zero);
      return side != Sign::zero || (dot(seen, direction) - here).sign() == Sign::negative;
    }
  };
  Plain plain() const {
    return {about, {near_of(direction.x), near_of(direction.y)}, near_of(moment), near_of(here)};
  }

  // A point as the line sees it.
  struct Sight {
    Number side, place;
  };
  Sight sight(const Vec2& point) const { return {side_of(point), place_of(point)}; }

  std::vector<CourseHit<Number>> meet(const Segment& wall, bool stood_on) const {
    if (stood_on) return {};
    return {meet_between(sight(wall.a), sight(wall.b))};
  }

  // To either side, at a point of the wall.
  Pair<Number> normal(const Segment& wall, const Pair<Number>&) const {
    const Pair<Number> edge = pair(wall.b) - pair(wall.a);
    return {-edge.y, edge.x};
  }
  Pair<Number> normal(const Arc& wall, const Pair<Number>& point) const {
    const Ellipse& curve = wall.curve;
    return curve_normal(make, curve, curve_form(make, curve, point - pair(curve.centre)));
  }

  Pair<Number> normal(const Bezier& wall, const Pair<Number>&) const {
    const Pair<Number> rate = rate_at(make, wall, *stood_at);
    return {-rate.y, rate.x};
  }

  // Where it has left the curve is a root that is known, by which the others are those of a quotient.
  std::vector<CourseHit<Number>> meet(const Bezier& wall, bool stood_on) const {
    constexpr int kSteps = 10;
    if (stood_on && !stood_at) return {{Met::open}};
    Bernstein<Number> beside = bernstein_of(make, wall, [&](const Vec2& p) { return side_of(p); });
    if (stood_on) beside = divided_by(beside, *stood_at);
    const auto plain = [](const Number& x) { return x.nearest().value_or(0.0); };
    const auto roots = bernstein_roots(make, plain, std::move(beside), kSteps);
    if (!roots) return {{Met::open}};
    const auto ahead = bernstein_of(make, wall, [&](const Vec2& p) { return place_of(p); });
    std::vector<CourseHit<Number>> met;
    for (const auto& root : *roots) {
      met.push_back(ahead_at(form_at(make, wall, ahead, root.s)));
      met.back().parameter = root.s;
      const bool at_end = root.s.sign() == Sign::zero || (root.s - make(1)).sign() == Sign::zero;
      if (met.back().met == Met::between && (at_end || root.multiplicity > 1))
        met.back().met = Met::end;
    }
    return met;
  }

  // Without the rest, which is 0 at a root.
  Bernstein<Number> divided_by(const Bernstein<Number>& c, const Number& root) const {
    const Number two = make(2), three = make(3), half = make(0.5);
    if (c.size() == 3) {
      const Number square = c[0] - two * c[1] + c[2], linear = two * (c[1] - c[0]);
      const Number constant = linear + root * square;
      return {constant, constant + square};
    }
    const Number cube = c[3] - c[0] + three * (c[1] - c[2]);
    const Number square = three * (c[0] - two * c[1] + c[2]), linear = three * (c[1] - c[0]);
    const Number middle = square + root * cube, constant = linear + root * middle;
    return {constant, constant + half * middle, constant + middle + cube};
  }

  // A straight wall between two points.
  CourseHit<Number> meet_between(const Sight& from, const Sight& to) const {
    const Number apart = from.side - to.side;
    const auto a = from.side.sign(), b = to.side.sign(), slope = apart.sign();
    if (a && a == b && *a != Sign::zero) return {Met::no};
    if (!slope || *slope == Sign::zero)
      return meet_along(from.place, to.place, a == Sign::zero && b == Sign::zero);
    const Number place = from.place + from.side / apart * (to.place - from.place);
    const auto ahead = (place - here).sign();
    if (ahead == Sign::negative) return {Met::no};
    if (!a || !b || ahead != Sign::positive) return {Met::open, place};
    return {*a == Sign::zero || *b == Sign::zero ? Met::end : Met::between, place, WallPart::line};
  }

  // A wall on the line, or so near that it cannot be told: it is met, if it is, between its ends.
  CourseHit<Number> meet_along(const Number& at_a, const Number& at_b, bool on_line) const {
    const auto a = (at_a - here).sign(), b = (at_b - here).sign();
    if (a == Sign::negative && b == Sign::negative) return {Met::no};
    const auto order = (at_a - at_b).sign();
    if (!order) return {Met::open};
    const bool surely = on_line && a == Sign::positive && b == Sign::positive;
    return {surely ? Met::end : Met::open, *order == Sign::negative ? at_a : at_b};
  }

  // What joins an end of an arc to its curve, on the line to the centre (see Arc).
  CourseHit<Number> meet_joint(const Ellipse& curve, const Vec2& end) const {
    if (curve_side(end, curve) == Sign::zero) return {Met::no};
    const Pair<Number> way = pair(end) - pair(curve.centre);
    const Pair<Number> form = curve_form(make, curve, way);
    const Number r = form_size(make, curve), share = square_root(r * r / dot(form, form));
    const Sight centre = sight(curve.centre);
    CourseHit<Number> meeting = meet_between(
        sight(end),
        {centre.side + share * cross(direction, way), centre.place + share * dot(way, direction)});
    if (meeting.met == Met::between) meeting.met = Met::end;
    meeting.part = WallPart::joint;
    meeting.end = end;
    return meeting;
  }

  // The chord of a curve on the line, by q = w.d at points w seen from its centre: with k = w cross
  // d, and F, G the forms of d and of d turned by a quarter, they are q = middle +- half, where
  // middle = -k F.G / F.F and half = |r| d.d sqrt(F.F - k^2) / F.F; in a circle F = d, G = d', and it
  // is the root of r^2 d.d - k^2.
  struct Chord {
    Number middle, square, scale;  // half is scale times the root of square
    Number k;
  };
  Chord chord(const Ellipse& curve) const {
    const Number k = side_of(curve.centre), r = form_size(make, curve);
    if (curve.is_circle()) return {make(0), r * r * size - k * k, make(1), k};
    const auto f = curve_form(make, curve, direction);
    const auto g = curve_form(make, curve, Pair<Number>{direction.y, -direction.x});
    const Number ff = dot(f, f);
    return {-(k * dot(f, g)) / ff, ff - k * k, r * size / ff, k};
  }

  // The point met, seen from the centre.
  Pair<Number> from_centre(const Number& q, const Number& k) const {
    const Pair<Number>& d = direction;
    return {(q * d.x + k * d.y) / size, (q * d.y - k * d.x) / size};
  }

  std::vector<CourseHit<Number>> meet(const Arc& arc, bool stood_on) const {
    const bool whole = arc.extent == Arc::Extent::whole;
    std::vector<CourseHit<Number>> met = meet_curve(arc.curve, stood_on, !whole);
    if (whole) return met;
    for (CourseHit<Number>& meeting : met) limit_to(arc, meeting);
    // Nothing but a tangent is neither root: it is passed by, but in an end.
    for (CourseHit<Number>& meeting : met)
      if (meeting.part == WallPart::other && meeting.met == Met::between) meeting.met = Met::no;
    if (arc.extent == Arc::Extent::between)
      for (const Vec2& end : {arc.from, arc.to}) met.push_back(meet_joint(arc.curve, end));
    return met;
  }

  // The whole curve; of tangents only where they touch is told, and that only if `tangents`.
  std::vector<CourseHit<Number>> meet_curve(const Ellipse& curve, bool stood_on,
                                            bool tangents) const {
    const Chord chord = this->chord(curve);
    const Number middle = place_of(curve.centre) + chord.middle;
    if (stood_on) {
      const auto leads = (here - middle).sign();
      if (leads == Sign::positive || leads == Sign::zero) return {};
      if (!leads) return {{Met::open}};
      return {{Met::between, middle + middle - here, WallPart::second_root}};
    }
    const auto reached = chord.square.sign();
    if (reached == Sign::negative || (reached == Sign::zero && !tangents)) return {};
    if (reached == Sign::zero) return {ahead_at(middle)};
    if (!reached) {  // just met or missed: where, if at all
      const CourseHit<Number> near = ahead_at(middle + chord.scale * either_root(chord.square));
      return {{near.met == Met::no ? Met::no : Met::open, near.place}};
    }
    Number half = chord.scale * square_root(chord.square);
    if (half.sign() == Sign::negative) half = -half;  // where u x v < 0
    return {ahead_at(middle - half, WallPart::first_root),
            ahead_at(middle + half, WallPart::second_root)};
  }

  // A place on a curve that another wall stands on, or the start, may be here.
  CourseHit<Number> ahead_at(const Number& place, WallPart part = WallPart::other) const {
    const auto ahead = (place - here).sign();
    if (ahead == Sign::negative) return {Met::no};
    return {ahead == Sign::positive ? Met::between : Met::open, place, part};
  }

  // Of a point of the curve, whether it is one of the arc.
  void limit_to(const Arc& arc, CourseHit<Number>& meeting) const {
    if (meeting.met == Met::no || !meeting.place) return;
    const Number centre = place_of(arc.curve.centre);
    const auto from = from_centre(*meeting.place - centre, side_of(arc.curve.centre));
    const auto point = pair(arc.curve.centre) + from;
    bool known = true;
    const PlaceOn place = place_in_cone(arc, [&](const Vec2& p, const Vec2& a, const Vec2& b) {
      const bool at_centre = p == arc.curve.centre;
      const auto sign = cross(pair(b) - pair(a), at_centre ? from : point - pair(p)).sign();
      known = known && sign;
      return sign.value_or(Sign::zero);
    });
    if (!known)
      meeting.met = Met::open;
    else if (place == PlaceOn::outside)
      meeting.met = Met::no;
    else if (place == PlaceOn::at_end && meeting.met == Met::between)
      meeting.met = Met::end;
  }
};

}  // namespace flatray
