#pragma once
#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "geom/pair.h"
#include "trace/surfaces.h"
#include "transport/landing.h"
#include "transport/periodic_walls.h"

namespace flatray {

/// What a ray comes to.
struct Prospect {
  enum class Kind : std::uint8_t {
    wall,    ///< meets one, between its ends
    corner,  ///< meets an end, or several walls at once
    escape,  ///< meets nothing
    open     ///< not to be told in this arithmetic
  } kind;
  std::vector<std::uint32_t> walls;  ///< ascending; one for a wall
};

/// A ray among mirrors, as exact as its arithmetic. It is a line x: x cross d = m, whose point met
/// does not enter what comes after a straight wall: errors grow there by sqrt 2 a bounce at most,
/// which is how a turn is bounded in components. Places on it count by x.d.
///
/// Needs   Number as geom/bounded.h has it; make(double) gives one without error. Walls that outlive
///         it, a direction that is not zero, a start in no corner. Periodic walls stop only what
///         leads out by them.
/// Gives   what is told is true, whatever the arithmetic.
template <class Number, class Make>
class Flight {
 public:
  Flight(const Surfaces& walls, const PeriodicWalls& periodic, const Ray& start, Make make)
      : walls_(walls),
        periodic_(periodic),
        make_(make),
        direction_(pair(start.direction)),
        moment_(cross(pair(start.origin), direction_)),
        here_(dot(pair(start.origin), direction_)),
        size_(dot(direction_, direction_)),
        point_(pair(start.origin)) {
    for (const std::uint32_t surface : Lander(walls).walls_at(start.origin)) left_ = surface;
  }

  Prospect next() const {
    if (periodic_.has(left_) && leads_out(left_) == true) return {Prospect::Kind::wall, {left_}};
    Prospect found{Prospect::Kind::escape, {}};
    std::vector<Number> best, open;  // places: of what is met first; of what may be missed
    for (std::uint32_t surface = 0; surface < walls_.size(); ++surface) {
      if (periodic_.has(surface)) {
        const auto out = leads_out(surface);
        if (!out) return {Prospect::Kind::open, {}};
        if (!*out) continue;
      }
      for (const Meeting& meeting : meetings(surface)) {
        if (meeting.met == Met::no) continue;
        if (!meeting.place) return {Prospect::Kind::open, {}};
        if (meeting.met == Met::open) {
          open.push_back(*meeting.place);
          continue;
        }
        const auto order = best.empty() ? Sign::positive : (best.front() - *meeting.place).sign();
        if (!order) return {Prospect::Kind::open, {}};
        if (*order == Sign::negative) continue;
        if (*order == Sign::positive) found.walls.clear();
        const bool alone = found.walls.empty() && meeting.met == Met::between;
        found.kind = alone ? Prospect::Kind::wall : Prospect::Kind::corner;
        if (found.walls.empty() || found.walls.back() != surface) found.walls.push_back(surface);
        best.assign(1, *meeting.place);
      }
    }
    for (const Number& place : open)
      if (best.empty() || (place - best.front()).sign() != Sign::positive)
        return {Prospect::Kind::open, {}};
    return found;
  }

  /// Goes on from a wall that the ray is known to meet next; false where Number cannot tell how.
  bool bounce(std::uint32_t surface) {
    const bool known =
        walls_.is_straight(surface) ? bounce_off(segment(surface)) : bounce_off_curve(surface);
    left_ = surface;
    return known;
  }

  /// Whether all that lies ahead are periodic walls.
  bool crosses(const Prospect& next) const {
    return (next.kind == Prospect::Kind::wall || next.kind == Prospect::Kind::corner) &&
           std::all_of(next.walls.begin(), next.walls.end(),
                       [&](std::uint32_t surface) { return periodic_.has(surface); });
  }

  /// Goes on from the walls opposite the periodic ones that it is known to meet next, and gives the
  /// point where it met them; nullopt where Number cannot tell it.
  std::optional<Pair<Number>> cross_over(const Prospect& next) {
    const auto met = meeting_point(segment(next.walls.front()));
    if (!met) return std::nullopt;
    point_ = *met;
    for (const std::uint32_t surface : next.walls) {
      const PeriodicWalls::Side& side = *periodic_.find(surface);
      const Number way = make_(side.far) - make_(side.near), none = make_(0);
      const Pair<Number> shift = side.axis == 0 ? Pair<Number>{way, none} : Pair<Number>{none, way};
      moment_ = moment_ + cross(shift, direction_);
      point_ = point_ + shift;
      left_ = side.opposite;
    }
    here_ = dot(point_, direction_);
    return met;
  }

  /// Where a wall is met that the ray is known to meet next, in a corner.
  std::optional<Pair<Number>> corner_at(std::uint32_t surface) const {
    if (!walls_.is_straight(surface))
      if (const auto meeting = first_of(surface); meeting && meeting->end)
        return pair(*meeting->end);
    Flight there(*this);
    if (there.bounce(surface)) return there.point_;
    if (!walls_.is_straight(surface)) return std::nullopt;
    const Segment& wall = segment(surface);  // on the line of the ray
    const auto order = (dot(pair(wall.a), direction_) - dot(pair(wall.b), direction_)).sign();
    if (!order) return std::nullopt;
    return pair(*order == Sign::positive ? wall.b : wall.a);
  }

  /// A normal of the wall that it has just bounced off, of any length, to either side.
  Pair<Number> normal(std::uint32_t surface) const {
    if (walls_.is_straight(surface)) {
      const Pair<Number> edge = pair(segment(surface).b) - pair(segment(surface).a);
      return {-edge.y, edge.x};
    }
    const Ellipse curve = walls_.curve(surface);
    return curve_normal(make_, curve, curve_form(make_, curve, point_ - pair(curve.centre)));
  }

  /// Where the last bounce was, or where it came in by a periodic wall.
  const Pair<Number>& point() const { return point_; }
  const Pair<Number>& direction() const { return direction_; }
  const Number& moment() const { return moment_; }
  /// d.d, which no mirror changes.
  const Number& size() const { return size_; }

 private:
  enum class Met { no, between, end, open };
  struct Meeting {
    Met met;
    std::optional<Number> place{};  // nullopt where it is open and may be anywhere
    std::optional<Vec2> end{};      // of an arc, where it is met there
  };

  Pair<Number> pair(const Vec2& v) const { return pair_of(make_, v); }

  const Segment& segment(std::uint32_t surface) const {
    return walls_.segments[walls_.slot[surface]];
  }

  std::vector<Meeting> meetings(std::uint32_t surface) const {
    if (!walls_.is_straight(surface)) return meet_arc(walls_.arc(surface), surface == left_);
    if (surface == left_) return {};
    return {meet_segment(segment(surface))};
  }

  // Of a curved wall that is known to be met. A place that is open may be that of a root.
  std::optional<Meeting> first_of(std::uint32_t surface) const {
    std::optional<Meeting> first;
    for (const Meeting& meeting : meetings(surface)) {
      if (meeting.met == Met::no) continue;
      if (!meeting.place) return std::nullopt;
      const auto order = first ? (*meeting.place - *first->place).sign() : Sign::negative;
      if (!order) return std::nullopt;
      if (*order == Sign::negative) first = meeting;
    }
    return first;
  }

  // Of a periodic wall; nullopt where Number cannot tell.
  std::optional<bool> leads_out(std::uint32_t surface) const {
    const PeriodicWalls::Side& side = *periodic_.find(surface);
    const auto sign = (side.axis == 0 ? direction_.x : direction_.y).sign();
    return sign ? std::optional(static_cast<double>(*sign) * side.out > 0) : std::nullopt;
  }

  // Where the line crosses a wall that it is known to cross; nullopt where Number cannot tell.
  std::optional<Pair<Number>> meeting_point(const Segment& wall) const {
    const Number side_a = side_of(wall.a), apart = side_a - side_of(wall.b);
    const auto slope = apart.sign();
    if (!slope || *slope == Sign::zero) return std::nullopt;
    const Number part = side_a / apart;
    return pair(wall.a) + part * (pair(wall.b) - pair(wall.a));
  }

  // On which side of the line a point lies: d cross (point - x), that is (x - point) cross d.
  Number side_of(const Vec2& point) const { return cross(direction_, pair(point)) + moment_; }

  // A point as the line sees it.
  struct Sight {
    Number side, place;
  };
  Sight sight(const Vec2& point) const { return {side_of(point), dot(pair(point), direction_)}; }

  Meeting meet_segment(const Segment& wall) const {
    return meet_between(sight(wall.a), sight(wall.b));
  }

  // A straight wall between two points.
  Meeting meet_between(const Sight& from, const Sight& to) const {
    const Number apart = from.side - to.side;
    const auto a = from.side.sign(), b = to.side.sign(), slope = apart.sign();
    if (a && a == b && *a != Sign::zero) return {Met::no};
    if (!slope || *slope == Sign::zero)
      return meet_along(from.place, to.place, a == Sign::zero && b == Sign::zero);
    const Number place = from.place + from.side / apart * (to.place - from.place);
    const auto ahead = (place - here_).sign();
    if (ahead == Sign::negative) return {Met::no};
    if (!a || !b || ahead != Sign::positive) return {Met::open, place};
    return {*a == Sign::zero || *b == Sign::zero ? Met::end : Met::between, place};
  }

  // A wall on the line, or so near that it cannot be told: it is met, if it is, between its ends.
  Meeting meet_along(const Number& at_a, const Number& at_b, bool on_line) const {
    const auto a = (at_a - here_).sign(), b = (at_b - here_).sign();
    if (a == Sign::negative && b == Sign::negative) return {Met::no};
    const auto order = (at_a - at_b).sign();
    if (!order) return {Met::open};
    const bool surely = on_line && a == Sign::positive && b == Sign::positive;
    return {surely ? Met::end : Met::open, *order == Sign::negative ? at_a : at_b};
  }

  // What joins an end of an arc to its curve, on the line to the centre (see Arc).
  Meeting meet_joint(const Ellipse& curve, const Vec2& end) const {
    if (curve_side(end, curve) == Sign::zero) return {Met::no};
    const Pair<Number> way = pair(end) - pair(curve.centre);
    const Pair<Number> form = curve_form(make_, curve, way);
    const Number size = form_size(make_, curve), share = square_root(size * size / dot(form, form));
    const Sight centre = sight(curve.centre);
    Meeting meeting = meet_between(sight(end), {centre.side + share * cross(direction_, way),
                                                centre.place + share * dot(way, direction_)});
    if (meeting.met == Met::between) meeting.met = Met::end;
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
    const Number k = side_of(curve.centre), r = form_size(make_, curve);
    if (curve.is_circle()) return {make_(0), r * r * size_ - k * k, make_(1), k};
    const auto f = curve_form(make_, curve, direction_);
    const auto g = curve_form(make_, curve, Pair<Number>{direction_.y, -direction_.x});
    const Number ff = dot(f, f);
    return {-(k * dot(f, g)) / ff, ff - k * k, r * size_ / ff, k};
  }

  // The point met, seen from the centre.
  Pair<Number> from_centre(const Number& q, const Number& k) const {
    const Pair<Number>& d = direction_;
    return {(q * d.x + k * d.y) / size_, (q * d.y - k * d.x) / size_};
  }

  std::vector<Meeting> meet_arc(const Arc& arc, bool stood_on) const {
    std::vector<Meeting> met = meet_curve(arc.curve, stood_on);
    if (arc.extent == Arc::Extent::whole) return met;
    for (Meeting& meeting : met) limit_to(arc, meeting);
    if (arc.extent == Arc::Extent::between)
      for (const Vec2& end : {arc.from, arc.to}) met.push_back(meet_joint(arc.curve, end));
    return met;
  }

  // The whole curve.
  std::vector<Meeting> meet_curve(const Ellipse& curve, bool stood_on) const {
    const Chord chord = this->chord(curve);
    const Number centre = dot(pair(curve.centre), direction_), middle = centre + chord.middle;
    if (stood_on) {
      const auto leads = (here_ - middle).sign();
      if (leads == Sign::positive || leads == Sign::zero) return {};
      if (!leads) return {{Met::open}};
      return {{Met::between, middle + middle - here_}};
    }
    const auto reached = chord.square.sign();
    if (reached == Sign::negative || reached == Sign::zero) return {};
    if (!reached) return {meet_about(curve, centre)};
    Number half = chord.scale * square_root(chord.square);
    if (half.sign() == Sign::negative) half = -half;  // where u x v < 0
    std::vector<Meeting> met;
    for (const Number& place : {middle - half, middle + half}) {
      const auto ahead = (place - here_).sign();
      if (!ahead || *ahead == Sign::zero) return {{Met::open}};
      if (*ahead == Sign::positive) met.push_back({Met::between, place});
    }
    return met;
  }

  // A curve that the line just meets or misses: if it is met, then within |u| + |v| of its centre.
  Meeting meet_about(const Ellipse& curve, const Number& centre) const {
    const auto u = pair(curve.u), v = pair(curve.v);
    const Number far = curve.is_circle() ? u.x : square_root(dot(u, u)) + square_root(dot(v, v));
    const Number reach = far * square_root(size_);
    if ((centre + reach - here_).sign() == Sign::negative) return {Met::no};
    return {Met::open, centre - reach};
  }

  // Of a point of the curve, whether it is one of the arc.
  void limit_to(const Arc& arc, Meeting& meeting) const {
    if (meeting.met == Met::no || !meeting.place) return;
    const Number centre = dot(pair(arc.curve.centre), direction_);
    const auto from = from_centre(*meeting.place - centre, side_of(arc.curve.centre));
    const auto point = pair(arc.curve.centre) + from;
    bool known = true;
    const ArcPlace place = place_in_cone(arc, [&](const Vec2& p, const Vec2& a, const Vec2& b) {
      const bool at_centre = p == arc.curve.centre;
      const auto sign = cross(pair(b) - pair(a), at_centre ? from : point - pair(p)).sign();
      known = known && sign;
      return sign.value_or(Sign::zero);
    });
    if (!known)
      meeting.met = Met::open;
    else if (place == ArcPlace::outside)
      meeting.met = Met::no;
    else if (place == ArcPlace::at_end && meeting.met == Met::between)
      meeting.met = Met::end;
  }

  // d' = d - 2 (d.n) n / n.n, a turn of d by known numbers; the moment about a point of the wall
  // changes its sign.
  bool bounce_off(const Segment& wall) {
    const Number side_a = side_of(wall.a), apart = side_a - side_of(wall.b);
    const auto slope = apart.sign();
    if (!slope || *slope == Sign::zero) return false;
    const Pair<Number> edge = pair(wall.b) - pair(wall.a), a = pair(wall.a);
    const Number length = dot(edge, edge), part = side_a / apart;
    const Number c = (edge.x * edge.x - edge.y * edge.y) / length;
    const Number s = make_(2) * edge.x * edge.y / length;
    direction_ = {c * direction_.x + s * direction_.y, s * direction_.x - c * direction_.y};
    moment_ = cross(a, direction_) - side_a;
    here_ = dot(a, direction_) + part * dot(edge, direction_);
    point_ = {a.x + part * edge.x, a.y + part * edge.y};
    return true;
  }

  bool bounce_off_curve(std::uint32_t surface) {
    const auto meeting = first_of(surface);
    if (!meeting) return false;
    const Ellipse curve = walls_.curve(surface);
    const Number q = *meeting->place - dot(pair(curve.centre), direction_);
    return curve.is_circle() ? bounce_off_circle(curve, q) : bounce_off_ellipse(curve, q);
  }

  // With q = w.d and k = w cross d at the point met, d' = (2 k^2 / r^2 d.d - 1) d + 2 q k / r^2 d.d
  // times d turned by a quarter; q changes its sign and k stays.
  bool bounce_off_circle(const Ellipse& wall, const Number& q) {
    const Pair<Number> centre = pair(wall.centre), d = direction_;
    const Number k = side_of(wall.centre);
    const Number r = form_size(make_, wall), scale = r * r * size_;
    const Number c = make_(2) * k * k / scale - make_(1), s = make_(2) * q * k / scale;
    point_ = centre + from_centre(q, k);
    direction_ = {c * d.x - s * d.y, c * d.y + s * d.x};
    moment_ = cross(centre, direction_) + k;
    here_ = dot(centre, direction_) - q;
    return true;
  }

  // d' = d - 2 (d.n) n / n.n with the normal n.
  bool bounce_off_ellipse(const Ellipse& wall, const Number& q) {
    const auto from = from_centre(q, side_of(wall.centre));
    const auto normal = curve_normal(make_, wall, curve_form(make_, wall, from));
    const Number share = make_(2) * dot(direction_, normal) / dot(normal, normal);
    point_ = pair(wall.centre) + from;
    direction_ = direction_ - share * normal;
    moment_ = cross(point_, direction_);
    here_ = dot(point_, direction_);
    return true;
  }

  const Surfaces& walls_;
  const PeriodicWalls& periodic_;
  Make make_;
  Pair<Number> direction_;
  Number moment_, here_, size_;
  Pair<Number> point_;
  std::uint32_t left_ = kNoSurface;
};

}  // namespace flatray
