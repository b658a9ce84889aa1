#include "transport/field_meeting.h"

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"
#include "geom/decide.h"
#include "transport/reflection.h"

namespace flatray {
namespace {

// (e x (x - base)): with g = base - o it is e x (w d + half d') / (w^2 + half^2) - e x g.
template <class Make, class Number>
FlightForm<Number> line_form(const Make& number, const FieldFlight& flight, const Vec2& base,
                             const Pair<Number>& e) {
  const auto d = pair_of(number, flight.ray.direction);
  const auto h = number(flight.half);
  const Number a = -cross(e, pair_of(number, base) - pair_of(number, flight.ray.origin));
  return {a, cross(e, d), h * (dot(e, d) + h * a)};
}

// |x - centre|^2 - r^2: with g = centre - o, |x - o|^2 - 2 (x - o).g + |g|^2 - r^2, and
// |x - o|^2 = |d|^2 / (w^2 + half^2).
template <class Make>
auto circle_form(const Make& number, const FieldFlight& flight, const Ellipse& circle) {
  const auto d = pair_of(number, flight.ray.direction);
  const auto h = number(flight.half), r = number(circle.u.x());
  const auto g = pair_of(number, circle.centre) - pair_of(number, flight.ray.origin);
  using Number = std::remove_cv_t<decltype(h)>;
  const Number a = dot(g, g) - r * r;
  return FlightForm<Number>{a, number(-2) * dot(d, g),
                            h * (h * a - number(2) * cross(d, g)) + dot(d, d)};
}

template <class Number>
Number discriminant(const FlightForm<Number>& form) {
  return form.b * form.b - Number(4) * form.a * form.c;
}

template <class Number>
Number value(const FlightForm<Number>& form, const Number& w) {
  return (form.a * w + form.b) * w + form.c;
}

double high(const Near& number) { return number.value(); }
double high(const Bounded& number) { return number.hi(); }

// As decide(), in plain doubles first.
template <class Formula>
Sign soon(const Formula& formula) {
  const auto sign = formula(kNear).sign();
  return sign ? *sign : decide(formula);
}

}  // namespace

template <class Make>
FlightForm<decltype(Make{}(0.0))> CrossedWall::form(const Make& number,
                                                    const FieldFlight& flight) const {
  if (circle != nullptr) return circle_form(number, flight, *circle);
  return line_form(number, flight, line.a, pair_of(number, line.b) - pair_of(number, line.a));
}

// Where -b and the root of q cancel: by the other root and the product of both.
template <class Make>
auto FieldMeeting::root(const Make& number) const {
  const auto form = crossed_.form(number, flight_);
  const auto length = square_root(discriminant(form));
  const auto signed_root = from_ == Sign::positive ? length : -length;
  return (high(form.b) < 0) == (from_ == Sign::positive)
             ? (signed_root - form.b) / (number(2) * form.a)
             : number(-2) * form.c / (form.b + signed_root);
}

// Before it a w^2 + b w + c, whose slope at (-b + s sqrt(q)) / 2a is s sqrt(q), has the sign of s.
FieldMeeting::FieldMeeting(const FieldFlight& flight, const CrossedWall& crossed, Sign from)
    : flight_(flight), crossed_(crossed), from_(from) {
  near_ = root(kNear);
  if (near_.sign()) return;
  const auto part = [&](auto which) {
    return soon([&](const auto& number) { return which(crossed_.form(number, flight_)); });
  };
  closes_ = part([](const auto& form) { return form.a; }) == Sign::zero &&
            part([](const auto& form) { return form.b; }) == -from_;
}

Quadratic FieldMeeting::exact() const {
  const auto form = crossed_.form(kRational, flight_);
  if (form.a.sign() == Sign::zero) return -form.c / form.b;
  const Rational twice = Rational(2) * form.a;
  return {-form.b / twice, Rational(static_cast<int>(from_)) / twice, discriminant(form)};
}

template <class Form>
Sign FieldMeeting::sign_at(const Form& form) const {
  if (const auto sign = value(form(kNear), near_).sign()) return *sign;
  if (const auto sign = value(form(kBounded), root(kBounded)).sign()) return *sign;
  return value(form(kQuadratic), exact()).sign();
}

bool FieldMeeting::is_before(const FieldMeeting& other) const {
  if (closes_ || other.closes_) return !closes_;
  if (const auto sign = (near_ - other.near_).sign()) return *sign == Sign::positive;
  if (const auto sign = (root(kBounded) - other.root(kBounded)).sign())
    return *sign == Sign::positive;
  return compare(exact(), other.exact()) > 0;
}

double FieldMeeting::w() const {
  const Bounded w = root(kBounded);
  return w.error() < 0x1p-60 * w.size() ? w.hi() : exact().nearest();
}

double FieldMeeting::time() const {
  constexpr double kPi = 0x1.921fb54442d18p+1;
  const double h = std::fabs(flight_.half);
  return (closes_ ? kPi : portable::atan2(h, w())) / h;
}

// Turned by twice the angle of (w, half).
Vec2 FieldMeeting::direction() const {
  const Vec2& d = flight_.ray.direction;
  if (closes_) return d;
  const double along = w(), size = std::max(std::fabs(along), std::fabs(flight_.half));
  const double a = along / size, b = flight_.half / size, sum = a * a + b * b;
  const double cosine = (a - b) * (a + b) / sum, sine = 2 * a * b / sum;
  return cosine * d + sine * Vec2(-d.y(), d.x());
}

// A coordinate of the point less `about`.
double FieldMeeting::rounded(int axis, double about) const {
  const Vec2& d = flight_.ray.direction;
  const double across = axis == 0 ? -d.y() : d.x(), h = flight_.half;
  const auto place = [&](const auto& number, const auto& w) {
    return (number(flight_.ray.origin[axis]) - number(about)) +
           (w * number(d[axis]) + number(h) * number(across)) / (w * w + number(h) * number(h));
  };
  const auto nearest = place(kBounded, root(kBounded)).nearest();
  return nearest ? *nearest : place(kQuadratic, exact()).nearest();
}

// A wall parallel to an axis gives one coordinate.
Vec2 FieldMeeting::nearest() const {
  const auto coordinate = [&](int axis) {
    const bool level = crossed_.circle == nullptr && crossed_.line.a[axis] == crossed_.line.b[axis];
    return level ? crossed_.line.a[axis] + 0.0 : rounded(axis, 0);
  };
  return {coordinate(0), coordinate(1)};
}

Vec2 FieldMeeting::normal(const Arc& wall) const {
  return {rounded(0, wall.curve.centre.x()), rounded(1, wall.curve.centre.y())};
}

Sign FieldMeeting::turn(const Vec2& p, const Vec2& a, const Vec2& b) const {
  return sign_at([&](const auto& number) {
    return line_form(number, flight_, p, pair_of(number, b) - pair_of(number, a));
  });
}

Sign FieldMeeting::side_of(const Arc& wall) const {
  return sign_at([&](const auto& number) { return circle_form(number, flight_, wall.curve); });
}

// It stays on the side that it starts on.
template <class Wall>
std::optional<Sign> FieldMeeting::touched_side(const Wall& wall, const CrossedWall& crossed) const {
  const Sign crosses =
      soon([&](const auto& number) { return discriminant(crossed.form(number, flight_)); });
  return crosses == Sign::zero ? std::optional(flatray::side_of(wall, flight_.ray.origin))
                               : std::nullopt;
}
std::optional<Sign> FieldMeeting::touched_side(const Segment& wall) const {
  return touched_side(wall, {wall});
}
std::optional<Sign> FieldMeeting::touched_side(const Arc& wall) const {
  return touched_side(wall, {{}, &wall.curve});
}

namespace {

class FirstMet {
 public:
  FirstMet(const Surfaces& walls, const FieldFlight& flight) : walls_(walls), flight_(flight) {}

  std::optional<FieldHit> find() {
    for (surface_ = 0; surface_ < walls_.size(); ++surface_)
      walls_.visit(surface_, [&](const auto& wall) { look_at(wall); });
    return first_;
  }

 private:
  void look_at(const Segment& wall) {
    offer({wall}, [&](const FieldMeeting& met) { return met.between_ends(wall); });
  }
  void look_at(const Arc& wall) {
    offer({{}, &wall.curve}, [&](const FieldMeeting& met) { return met.place_in(wall); });
    if (wall.extent == Arc::Extent::between)
      for (const Vec2& end : {wall.from, wall.to}) look_at_joint(wall, end);
  }
  void look_at(const Bezier&) {}

  // What lies between an end that is not on the curve and the curve.
  void look_at_joint(const Arc& wall, const Vec2& end) {
    const Sign side = curve_side(end, wall.curve);
    if (side == Sign::zero) return;
    offer({{wall.curve.centre, end}}, [&](const FieldMeeting& met) {
      const bool joins = met.side_of(wall) == side && met.is_on_joint(wall, side, end);
      return joins ? PlaceOn::at_end : PlaceOn::outside;
    });
  }

  template <class Place>
  void offer(const CrossedWall& crossed, const Place& place) {
    const Sign crosses =
        soon([&](const auto& number) { return discriminant(crossed.form(number, flight_)); });
    if (crosses != Sign::positive) return;
    for (const Sign from : {Sign::positive, Sign::negative}) {
      const FieldMeeting met(flight_, crossed, from);
      if (first_ && !met.is_before(first_->meeting)) continue;
      // The start is between the ends of the wall that it is on: else it is a corner.
      const PlaceOn where = met.closes() ? place_of_start() : place(met);
      if (where != PlaceOn::outside)
        first_.emplace(FieldHit{surface_, where == PlaceOn::at_end, met});
    }
  }
  PlaceOn place_of_start() const {
    return walls_.visit(surface_,
                        [&](const auto& wall) { return place_on(wall, flight_.ray.origin); });
  }

  const Surfaces& walls_;
  const FieldFlight& flight_;
  std::uint32_t surface_ = 0;
  std::optional<FieldHit> first_;
};

}  // namespace

std::optional<FieldHit> first_in_field(const Surfaces& walls, const FieldFlight& flight) {
  return FirstMet(walls, flight).find();
}

// By half the angle flown, whose tangent is that between the direction and the chord.
std::vector<Vec2> points_between(double field, const Ray& flight, const Vec2& to) {
  constexpr double kPi = 0x1.921fb54442d18p+1, kParts = 256;
  const Vec2 d = unit(flight.direction), left = (field < 0 ? -1 : 1) * Vec2(-d.y(), d.x());
  const Vec2 way = to - flight.origin;
  const double half = way == Vec2(0, 0) ? kPi : portable::atan2(way.dot(left), way.dot(d));
  const double whole = half < 0 ? half + kPi : half;  // just below 0 by rounding
  const int parts = static_cast<int>(std::ceil(kParts * whole / kPi));
  std::vector<Vec2> points;
  for (int i = 1; i < parts; ++i) {
    const double part = whole * i / parts, sine = portable::sin(part);
    points.push_back(flight.origin +
                     2 * sine / std::fabs(field) * (portable::cos(part) * d + sine * left));
  }
  return points;
}

}  // namespace flatray
