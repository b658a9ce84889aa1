#include "oracle/curves.h"

#include <algorithm>

#include "oracle/point.h"

namespace flatray::oracle {
namespace {

// The coordinates in which a curve is a circle about 0.
class Frame {
 public:
  explicit Frame(const Ellipse& curve) : round_(curve.is_circle()) {
    if (round_) {
      square_ = Rational(curve.u.x()) * curve.u.x();
      return;
    }
    const Point u = exact(curve.u), v = exact(curve.v);
    const Rational size = cross(u, v);
    across_u_ = {v.y / size, -v.x / size};
    across_v_ = {-u.y / size, u.x / size};
    square_ = 1;
  }
  Point of(const Point& w) const {
    return round_ ? w : Point{dot(across_u_, w), dot(across_v_, w)};
  }
  const Rational& square_of_radius() const { return square_; }
  // Positive outside.
  Sign side(const Point& w) const {
    const Point p = of(w);
    return (dot(p, p) - square_).sign();
  }

 private:
  bool round_;
  Point across_u_, across_v_;
  Rational square_;
};

// The foot of the perpendicular from the centre on a line, and the square of half the chord about
// it, negative where the line passes by; both in lengths of the way.
struct Chord {
  Rational foot, square;
};
Chord chord_of(const Frame& frame, const Point& from, const Point& way) {
  const Point o = frame.of(from), d = frame.of(way);
  const Rational speed = dot(d, d), foot = -dot(o, d) / speed;
  const Point nearest = o + foot * d;
  return {foot, (frame.square_of_radius() - dot(nearest, nearest)) / speed};
}

// A point seen from the centre that moves along a line: only signs of what is linear in it are
// asked for.
struct Moving {
  Point from, way;
  Surd t;
  Sign turn(const Point& a) const { return t.mapped(cross(a, from), cross(a, way)).sign(); }
  Sign ahead(const Point& a) const { return t.mapped(dot(a, from), dot(a, way)).sign(); }
};

// Which part of a turn from `a` counter-clockwise a direction is in, by the signs of the area and
// the inner product of both: none, less than a half, a half, more.
int part_of_turn(Sign turn, Sign ahead) {
  if (turn == Sign::zero) return ahead == Sign::positive ? 0 : 2;
  return turn == Sign::positive ? 1 : 3;
}

PlaceOn place_of(Sign inside) {
  return inside == Sign::zero       ? PlaceOn::at_end
         : inside == Sign::positive ? PlaceOn::inner
                                    : PlaceOn::outside;
}

PlaceOn place_in(const Arc& arc, const Moving& point) {
  if (arc.extent == Arc::Extent::whole) return PlaceOn::inner;
  if (arc.extent == Arc::Extent::half) return place_of(point.ahead(exact(arc.from)));
  const Point centre = exact(arc.curve.centre);
  const Point from = exact(arc.from) - centre, to = exact(arc.to) - centre;
  const int part = part_of_turn(point.turn(from), point.ahead(from));
  const int last = part_of_turn(cross(from, to).sign(), dot(from, to).sign());
  if (part == 0) return PlaceOn::at_end;
  if (part != last) return part < last ? PlaceOn::inner : PlaceOn::outside;
  return place_of(part == 2 ? Sign::zero : -point.turn(to));
}

// A ray and an arc as seen from its centre.
class Meetings {
 public:
  Meetings(const Ray& ray, const Arc& arc)
      : arc_(arc),
        frame_(arc.curve),
        centre_(exact(arc.curve.centre)),
        from_(exact(ray.origin) - centre_),
        way_(exact(ray.direction)) {}

  std::optional<WallHit> first() {
    if (arc_.extent == Arc::Extent::between)
      for (const Vec2& end : {arc_.from, arc_.to}) offer_joint(exact(end) - centre_);
    if (is_zero(way_))
      offer_point();
    else
      offer_roots();
    return std::move(best_);
  }

 private:
  // Of meetings at one time that of the curve counts, which is offered last.
  void offer(Surd t, HitClass kind, Root root, bool at_end) {
    if (t.sign() == Sign::negative || (best_ && best_->t < t)) return;
    best_ = WallHit{std::move(t), kind, root, at_end};
  }
  void offer_on_curve(const Surd& t, HitClass kind, Root root) {
    const PlaceOn there = place_in(arc_, Moving{from_, way_, t});
    if (there != PlaceOn::outside) offer(t, kind, root, there == PlaceOn::at_end);
  }

  void offer_point() {
    if (frame_.side(from_) == Sign::zero) offer_on_curve({}, HitClass::touch, Root::none);
  }

  void offer_roots() {
    const auto [foot, chord] = chord_of(frame_, from_, way_);
    if (chord == 0) return offer_on_curve({foot}, HitClass::touch, Root::both);
    if (chord < 0) return;
    offer_on_curve({foot, 1, chord}, HitClass::through, Root::second);
    offer_on_curve({foot, -1, chord}, HitClass::through, Root::first);
  }

  // Where the ray meets what joins an end, off the curve, to the curve: the points s `end` from
  // s = 1 to that on the curve. One along the ray is met at the start, if that is on it, else at the end itself.
  void offer_joint(const Point& end) {
    const Sign side = frame_.side(end);
    if (side == Sign::zero) return;
    const Rational turn = cross(end, way_);
    Point at = end;
    if (turn.sign() != Sign::zero) {
      const Rational s = cross(from_, way_) / turn;
      if (s.sign() != Sign::positive || (s - 1).sign() == side) return;
      at = s * end;
    } else {
      if (cross(end, from_).sign() != Sign::zero) return;
      offer_start_on_joint(end, side);
      if (is_zero(way_)) return;
    }
    if (-frame_.side(at) == side) return;
    const Point to = at - from_;
    offer({dot(to, way_) / dot(way_, way_), 0, 0}, HitClass::touch, Root::none, true);
  }

  // The start of a ray on the line of a joint: on it, if ahead of the centre, between the end and the curve.
  void offer_start_on_joint(const Point& end, Sign side) {
    const Sign beyond = (dot(end, from_) - dot(end, end)).sign();
    if (dot(end, from_).sign() != Sign::positive || beyond == side) return;
    if (-frame_.side(from_) == side) return;
    offer({}, HitClass::touch, Root::none, true);
  }

  const Arc& arc_;
  Frame frame_;
  Point centre_, from_, way_;
  std::optional<WallHit> best_;
};

// Of a ray without direction: its start between the ends of a wall.
std::optional<WallHit> meeting_with_start(const Point& to_a, const Point& to_b) {
  if (cross(to_a, to_b) != 0 || dot(to_a, to_b) > 0) return std::nullopt;
  return WallHit{{}, HitClass::touch, Root::none, is_zero(to_a) || is_zero(to_b)};
}

// Of a wall on the line of the ray, whose ends lie so far ahead.
std::optional<WallHit> meeting_along(const Rational& to_a, const Rational& to_b) {
  const auto& [first, last] = std::minmax(to_a, to_b);
  if (last < 0) return std::nullopt;
  const HitClass kind = first == last || last == 0 ? HitClass::touch : HitClass::along;
  return WallHit{{first < 0 ? 0 : first}, kind, Root::none, first >= 0 || last == 0};
}

}  // namespace

std::optional<WallHit> first_wall_hit(const Ray& ray, const Segment& wall) {
  const Point from = exact(ray.origin), way = exact(ray.direction);
  const Point to_a = exact(wall.a) - from, to_b = exact(wall.b) - from, along = to_b - to_a;
  if (is_zero(way)) return meeting_with_start(to_a, to_b);
  // t = time / across, and place / across runs from 0 at a to 1 at b.
  Rational across = cross(way, along), place = cross(to_a, way), time = cross(to_a, along);
  if (across == 0 && place == 0)
    return meeting_along(dot(to_a, way) / dot(way, way), dot(to_b, way) / dot(way, way));
  if (across < 0) across = -across, place = -place, time = -time;
  if (across == 0 || time < 0 || place < 0 || place > across) return std::nullopt;
  return WallHit{{time / across}, HitClass::touch, Root::none, place == 0 || place == across};
}

std::optional<WallHit> first_wall_hit(const Ray& ray, const Arc& arc) {
  return Meetings(ray, arc).first();
}

std::optional<Surd> root_of(const Ray& ray, const Ellipse& curve, Root root) {
  const Chord chord =
      chord_of(Frame(curve), exact(ray.origin) - exact(curve.centre), exact(ray.direction));
  if (chord.square.sign() == Sign::negative) return std::nullopt;
  if (chord.square.sign() == Sign::zero) return Surd{chord.foot, 0, 0};
  return Surd{chord.foot, root == Root::first ? -1 : 1, chord.square};
}

}  // namespace flatray::oracle
