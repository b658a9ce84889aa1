#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <vector>

#include "geom/pair.h"
#include "precise/course.h"
#include "trace/surfaces.h"
#include "transport/exact_origin.h"
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

/// A ray among mirrors, as exact as its arithmetic. Where it met a straight wall does not enter what
/// comes after, and a mirror keeps the length of an error of its direction: between straight walls and
/// in a circle errors grow as powers of the number of bounces, in bits by its logarithm.
///
/// Needs   Number as geom/enclosure.h has it; make(double) gives one without error. Walls that outlive
///         it, a direction that is not zero, a start in no corner. Periodic walls stop only what
///         leads out by them.
/// Gives   what is told is true, whatever the arithmetic.
template <class Number, class Make>
class Flight {
 public:
  Flight(const Surfaces& walls, const PeriodicWalls& periodic, const Ray& start, Make make)
      : walls_(walls),
        periodic_(periodic),
        course_(start, make),
        point_(pair(start.origin)),
        first_entry_(point_) {
    boxes_.reserve(walls.size());
    for (std::uint32_t surface = 0; surface < walls.size(); ++surface)
      boxes_.push_back(box_of(surface));
    for (const auto surface : ExactOrigins(walls).walls_at(start.origin)) {
      const auto* copy = periodic.find_copy(surface);
      if (copy == nullptr || stands_on(*copy)) departed_ = surface;
    }
  }

  Prospect next() const {
    if (periodic_.has(departed_) && leads_out(departed_) == true)
      return {Prospect::Kind::wall, {departed_}};
    Prospect found{Prospect::Kind::escape, {}};
    std::optional<CourseHit<Number>> best;  // of what is met first
    std::vector<Number> open;               // places of what may be missed
    const auto line = course_.plain();
    for (std::uint32_t surface = 0; surface < walls_.size(); ++surface) {
      if (line.passes(boxes_[surface])) continue;
      if (periodic_.has(surface)) {
        const auto out = leads_out(surface);
        if (!out) return {Prospect::Kind::open, {}};
        if (!*out) continue;
      }
      for (CourseHit<Number>& meeting : meetings(surface)) {
        if (meeting.met == Met::no) continue;
        if (!meeting.place) return {Prospect::Kind::open, {}};
        if (meeting.met == Met::open) {
          open.push_back(*meeting.place);
          continue;
        }
        const auto order = best ? order_of(*best, meeting) : Sign::positive;
        if (!order) return {Prospect::Kind::open, {}};
        if (*order == Sign::negative) continue;
        if (*order == Sign::positive) found.walls.clear();
        const bool alone = found.walls.empty() && meeting.met == Met::between;
        found.kind = alone ? Prospect::Kind::wall : Prospect::Kind::corner;
        if (found.walls.empty() || found.walls.back() != surface) found.walls.push_back(surface);
        best = std::move(meeting);
      }
    }
    for (const Number& place : open)
      if (!best || (place - *best->place).sign() != Sign::positive)
        return {Prospect::Kind::open, {}};
    return found;
  }

  /// Goes on from a wall that the ray is known to meet next; false where Number cannot tell how.
  bool bounce(std::uint32_t surface) {
    const auto* copy = periodic_.find_copy(surface);
    const bool known =
        copy != nullptr
            ? bounce_off(*copy)
            : walls_.visit(surface, [&](const auto& wall) { return bounce_off(wall, surface); });
    departed_ = surface;
    crossings_ = 0;
    return known;
  }

  /// Whether all that lies ahead are periodic walls.
  bool crosses(const Prospect& next) const {
    return (next.kind == Prospect::Kind::wall || next.kind == Prospect::Kind::corner) &&
           std::ranges::all_of(next.walls,
                               [&](std::uint32_t surface) { return periodic_.has(surface); });
  }

  /// Goes on from the walls opposite the periodic ones that it is known to meet next, and gives the
  /// point where it met them; nullopt where Number cannot tell it.
  std::optional<Pair<Number>> cross_over(const Prospect& next);

  /// After it has crossed one wall: crosses the same again and again, as long as all else that could be
  /// met lies on one side of its way, and tells see(from, to, step) of each time. Gives the t that takes, 0
  /// where the next flight must be looked at; nullopt where Number cannot tell the points.
  template <class See>
  std::optional<Number> cross_on(const Prospect& last, const See& see);

  /// Whether it has crossed periodic walls until that is an escape: see OrbitEnd.
  bool circles() const { return circles_ || crossings_ >= kMostCrossings; }

  /// Where a wall is met that the ray is known to meet next, in a corner.
  std::optional<Pair<Number>> corner_at(std::uint32_t surface) const {
    if (const auto meeting = first_of(surface); meeting && meeting->end) {
      const Vec2& end = *meeting->end;
      return pair(end) +
             course_.from_centre(*meeting->place - course_.place_of(end), course_.side_of(end));
    }
    Flight there(*this);
    if (there.bounce(surface)) return there.point_;
    if (walls_.segment_slot(surface) == kNoSurface) return std::nullopt;
    const Segment& wall = walls_.segment(surface);  // on the line of the ray
    const auto order =
        (dot(pair(wall.a), course_.direction) - dot(pair(wall.b), course_.direction)).sign();
    if (!order) return std::nullopt;
    return pair(*order == Sign::positive ? wall.b : wall.a);
  }

  /// Makes balls of all that may go on without error. Of Certain.
  void blur() {
    Pair<Number>& d = course_.direction;
    for (Number* x : {&d.x, &d.y, &course_.moment, &course_.here, &point_.x, &point_.y,
                      &first_entry_.x, &first_entry_.y})
      *x = x->blurred();
    if (course_.stood_at) course_.stood_at = course_.stood_at->blurred();
    d = {d.x + d.y.rest(), d.y + d.x.rest()};  // see turn
  }

  /// A normal of the wall that it has just bounced off, of any length, to either side.
  Pair<Number> normal(std::uint32_t surface) const {
    if (const auto* copy = periodic_.find_copy(surface))
      return course_.normal(walls_.arc(copy->of), point_ - way_of(copy->step));
    return walls_.visit(surface, [&](const auto& wall) { return course_.normal(wall, point_); });
  }

  /// Where the last bounce was, or where it came in by a periodic wall; in which cell that is.
  const Pair<Number>& point() const { return point_; }
  const CellIndex& cell() const { return cell_; }
  const Pair<Number>& direction() const { return course_.direction; }
  const Number& moment() const { return course_.moment; }
  /// d.d, which no mirror changes.
  const Number& size() const { return course_.size; }

 private:
  // Of a copy where it is, of which the surface's own place is rounded.
  Pair<Near> box_of(std::uint32_t surface) const {
    const auto* copy = periodic_.find_copy(surface);
    if (copy == nullptr)
      return walls_.visit(surface, [](const auto& wall) { return within(bounds_of(wall)); });
    const Pair<Number> way = way_of(copy->step);
    return within(bounds_of(walls_.arc(copy->of))) + Pair<Near>{near_of(way.x), near_of(way.y)};
  }

  Pair<Number> pair(const Vec2& v) const { return course_.pair(v); }

  // As many vectors of the lattice.
  Pair<Number> way_of(const CellIndex& step) const {
    const auto& [a, b] = periodic_.exact_lattice();
    return course_.make(static_cast<double>(step.a)) * (pair(a.b) - pair(a.a)) +
           course_.make(static_cast<double>(step.b)) * (pair(b.b) - pair(b.a));
  }

  // Whether the start surely is on the disc that a wall is a copy of.
  bool stands_on(const PeriodicWalls::Copy& copy) const {
    const Ellipse& disc = walls_.arc(copy.of).curve;
    return curve_power(course_.make, disc, point_ - way_of(copy.step) - pair(disc.centre)).sign() ==
           Sign::zero;
  }

  std::vector<CourseHit<Number>> meetings(std::uint32_t surface) const {
    const auto* copy = periodic_.find_copy(surface);
    std::vector<CourseHit<Number>> met =
        copy != nullptr ? meetings(*copy) : walls_.visit(surface, [&](const auto& wall) {
          return course_.meet(wall, stands_on(wall, surface));
        });
    for (CourseHit<Number>& meeting : met) meeting.surface = surface;
    return met;
  }

  // As the disc of which it is a copy is met from where the ray is as far from that.
  std::vector<CourseHit<Number>> meetings(const PeriodicWalls::Copy& copy) const {
    const Pair<Number> way = way_of(copy.step);
    Course<Number, Make> there = course_;
    there.move({-way.x, -way.y});
    auto met = there.meet(walls_.arc(copy.of), copy.surface == departed_);
    for (CourseHit<Number>& meeting : met)
      if (meeting.place) meeting.place = *meeting.place + dot(way, course_.direction);
    return met;
  }

  // Of its own curve, whichever part of it was left.
  template <class Wall>
  bool stands_on(const Wall&, std::uint32_t surface) const {
    return surface == departed_;
  }
  bool stands_on(const Arc& arc, std::uint32_t surface) const {
    const auto is_arc = []<class Wall>(const Wall&) { return std::is_same_v<Wall, Arc>; };
    return surface == departed_ || (departed_ != kNoSurface && walls_.visit(departed_, is_arc) &&
                                    is_same_curve(walls_.arc(departed_).curve, arc.curve));
  }

  // Of places that are known: positive where b comes first.
  std::optional<Sign> order_of(const CourseHit<Number>& a, const CourseHit<Number>& b) const {
    const auto order = (*a.place - *b.place).sign();
    return !order && is_same_point(a, b) ? Sign::zero : order;
  }

  // Whether two walls are met in one point because they lie on each other.
  bool is_same_point(const CourseHit<Number>& a, const CourseHit<Number>& b) const {
    if (a.part != b.part || a.part == WallPart::other) return false;
    if (a.part == WallPart::line)
      return lies_along(walls_.segment(b.surface), walls_.segment(a.surface));
    return a.end == b.end && !periodic_.find_copy(a.surface) && !periodic_.find_copy(b.surface) &&
           is_same_curve(walls_.arc(a.surface).curve, walls_.arc(b.surface).curve);
  }

  static bool is_same(const Pair<Number>& a, const Pair<Number>& b) {
    return (a.x - b.x).sign() == Sign::zero && (a.y - b.y).sign() == Sign::zero;
  }

  // Of a wall that is known to be met. A place that is open may be that of a root.
  std::optional<CourseHit<Number>> first_of(std::uint32_t surface) const {
    std::optional<CourseHit<Number>> first;
    for (const CourseHit<Number>& meeting : meetings(surface)) {
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
    const Segment& wall = periodic_.find(surface)->wall;
    const auto turn = cross(pair(wall.b) - pair(wall.a), course_.direction).sign();
    return turn ? std::optional(*turn == Sign::negative) : std::nullopt;
  }

  // Up to where on an axis nothing can be met in any cell but the wall crossed; nullopt beside what can.
  std::optional<double> end_of_free(const Segment& wall, int axis, const Number& place,
                                    Sign heading) const;

  // Where the line crosses a wall that it is known to cross, as a part of the way between its ends; nullopt
  // where Number cannot tell.
  std::optional<Number> part_at(const Segment& wall) const {
    const Number side_a = course_.side_of(wall.a), apart = side_a - course_.side_of(wall.b);
    const auto slope = apart.sign();
    if (!slope || *slope == Sign::zero) return std::nullopt;
    return side_a / apart;
  }

  // `isometry` takes a vector without error to what becomes of it. That keeps the length of an error,
  // so both components carry a bound of it as a vector: one for each alone would grow by sqrt 2.
  template <class Isometry>
  void turn(const Isometry& isometry) {
    const Number rest = course_.direction.x.rest();
    const Pair<Number> to =
        isometry(Pair<Number>{course_.direction.x.middle(), course_.direction.y.middle()});
    course_.direction = {to.x + rest + to.y.rest(), to.y + rest + to.x.rest()};
  }

  // d' = d - 2 (d.n) n / n.n, a reflection of d by known numbers; the moment about a point of the
  // wall changes its sign.
  bool bounce_off(const Segment& wall, std::uint32_t) {
    const auto part = part_at(wall);
    if (!part) return false;
    const Pair<Number> edge = pair(wall.b) - pair(wall.a);
    const Number side_a = course_.side_of(wall.a), length = dot(edge, edge);
    const Number c = (edge.x * edge.x - edge.y * edge.y) / length;
    const Number s = course_.make(2) * edge.x * edge.y / length;
    turn([&](const Pair<Number>& d) { return Pair<Number>{c * d.x + s * d.y, s * d.x - c * d.y}; });
    course_.about = wall.a;
    course_.moment = -side_a;
    course_.here = *part * dot(edge, course_.direction);
    point_ = pair(wall.a) + *part * edge;
    return true;
  }

  bool bounce_off(const Arc& arc, std::uint32_t surface) {
    const auto meeting = first_of(surface);
    if (!meeting) return false;
    const Ellipse& curve = arc.curve;
    const Number q = *meeting->place - course_.place_of(curve.centre);
    return curve.is_circle() ? bounce_off_circle(curve, q) : bounce_off_ellipse(curve, q);
  }

  bool bounce_off(const PeriodicWalls::Copy& copy) {
    const Pair<Number> way = way_of(copy.step);
    course_.move({-way.x, -way.y});
    departed_ = departed_ == copy.surface ? copy.of : kNoSurface;
    const bool known = bounce_off(walls_.arc(copy.of), copy.of);
    course_.move(way);
    point_ = point_ + way;
    return known;
  }

  bool bounce_off(const Bezier& wall, std::uint32_t surface) {
    auto meeting = first_of(surface);
    if (!meeting || !meeting->parameter) return false;
    const Number s = std::move(*meeting->parameter);
    const Pair<Number> point = point_at(course_.make, wall, s),
                       rate = rate_at(course_.make, wall, s);
    bounce_off_curve(wall.start(), point - pair(wall.start()), {-rate.y, rate.x});
    course_.stood_at = s;
    return true;
  }

  // With q = w.d and k = w cross d at the point met, d' = (2 k^2 / r^2 d.d - 1) d + 2 q k / r^2 d.d
  // times d turned by a quarter; q changes its sign and k stays.
  bool bounce_off_circle(const Ellipse& wall, const Number& q) {
    const Pair<Number> centre = pair(wall.centre);
    const Number k = course_.side_of(wall.centre);
    const Number r = form_size(course_.make, wall), scale = r * r * course_.size;
    const Number c = course_.make(2) * k * k / scale - course_.make(1),
                 s = course_.make(2) * q * k / scale;
    point_ = centre + course_.from_centre(q, k);
    turn([&](const Pair<Number>& d) { return Pair<Number>{c * d.x - s * d.y, c * d.y + s * d.x}; });
    course_.about = wall.centre;
    course_.moment = k;
    course_.here = -q;
    return true;
  }

  bool bounce_off_ellipse(const Ellipse& wall, const Number& q) {
    const auto from = course_.from_centre(q, course_.side_of(wall.centre));
    bounce_off_curve(wall.centre, from,
                     curve_normal(course_.make, wall, curve_form(course_.make, wall, from)));
    return true;
  }

  // d' = d - 2 (d.n) n / n.n with the normal n, at a point as seen from `about`.
  void bounce_off_curve(const Vec2& about, const Pair<Number>& from, const Pair<Number>& normal) {
    const Number size = dot(normal, normal);
    point_ = pair(about) + from;
    turn([&](const Pair<Number>& d) {
      return d - course_.make(2) * dot(d, normal) / size * normal;
    });
    course_.about = about;
    course_.moment = cross(from, course_.direction);
    course_.here = dot(from, course_.direction);
  }

  const Surfaces& walls_;
  const PeriodicWalls& periodic_;
  std::vector<Pair<Near>> boxes_;  // about the walls
  Course<Number, Make> course_;
  Pair<Number> point_;
  std::uint32_t departed_ = kNoSurface;
  CellIndex cell_{};
  std::uint32_t crossings_ = 0;  // since the last bounce
  Pair<Number> first_entry_;     // to which the first of them led
  bool circles_ = false;
};

}  // namespace flatray

#include "precise/flight_cells.h"
