#pragma once
#include <optional>
#include <vector>

#include "geom/exact_point.h"
#include "geom/primitives/wall.h"
#include "trace/surfaces.h"

namespace flatray {

/// A flight in a magnetic field across the room: a circle that its ray touches where it sets off.
///
/// Units   its centre is `direction`, turned a quarter to the left, by 2 `half` from the origin: `half` is half
///         the angle that it turns, to the left, in one t. Not 0.
struct FieldFlight {
  Ray ray;
  double half;
};

/// Points x of a flight by w = (x - o).d / |x - o|^2, which falls along it from infinity to minus infinity
/// and is half / tan(half t): x = o + (w d + half d') / (w^2 + half^2), d' = (-d_y, d_x). Sides of lines
/// and circles at x have the sign of a w^2 + b w + c.
template <class Number>
struct FlightForm {
  Number a, b, c;
};

/// The line through a segment or a circle, as a flight crosses it.
struct CrossedWall {
  Segment line{};
  const Ellipse* circle = nullptr;  ///< in place of the line

  template <class Make>
  FlightForm<decltype(Make{}(0.0))> form(const Make& number, const FieldFlight& flight) const;
};

/// The point at which a flight crosses a line or circle from one side to the other, without rounding.
///
/// Cost    plain doubles with bounds decide, some 0.1 us a question; where they cannot, double-doubles, then
///         rationals, 20 us.
class FieldMeeting : public ExactPoint<FieldMeeting> {
 public:
  /// Needs   a flight that crosses `crossed`, which outlives it, from that side.
  FieldMeeting(const FieldFlight& flight, const CrossedWall& crossed, Sign from);

  /// The side of what it crosses it comes from.
  Sign from() const { return from_; }
  /// Whether it is the start, to which the flight comes back from behind.
  bool closes() const { return closes_; }
  /// Whether it comes before another on the same flight. Exact.
  bool is_before(const FieldMeeting& other) const;
  /// When it is, and the direction then. Error   some 4 ulp.
  double time() const;
  Vec2 direction() const;

  /// As ExactHit has them. Need   !closes(), walls that are straight or of circles.
  Vec2 nearest() const;
  Vec2 normal(const Segment& wall) const { return normal_near(wall, Vec2(0, 0)); }
  Vec2 normal(const Arc& wall) const;
  Vec2 normal(const Bezier&) const { return {0, 0}; }
  Sign turn(const Vec2& p, const Vec2& a, const Vec2& b) const;
  using ExactPoint::side_of;
  Sign side_of(const Arc& wall) const;
  Sign side_of(const Bezier&) const { return Sign::zero; }
  using ExactPoint::place_on;
  PlaceOn place_on(const Bezier&) const { return PlaceOn::outside; }
  std::optional<Sign> touched_side(const Segment& wall) const;
  std::optional<Sign> touched_side(const Arc& wall) const;
  std::optional<Sign> touched_side(const Bezier&) const { return std::nullopt; }

 private:
  template <class Make>
  auto root(const Make& number) const;
  Quadratic exact() const;
  template <class Wall>
  std::optional<Sign> touched_side(const Wall& wall, const CrossedWall& crossed) const;
  template <class Form>
  Sign sign_at(const Form& form) const;
  double rounded(int axis, double about) const;
  double w() const;

  FieldFlight flight_;
  CrossedWall crossed_;
  Sign from_;
  bool closes_ = false;
  Near near_ = 0.0;
};

/// The first wall that a flight meets.
struct FieldHit {
  std::uint32_t surface;
  bool at_end;  ///< exactly at an end of it
  FieldMeeting meeting;
};

/// Walls are closed: their ends belong to them. One touched in a point between its ends is passed by, as is the
/// one left at t = 0, until the flight has come round to it.
///
/// Needs   walls that are straight or of circles.
/// Gives   nullopt where the flight closes without meeting one. Exact; of walls met at once the lowest.
/// Cost    looks at all walls, some 0.1 us each.
std::optional<FieldHit> first_in_field(const Surfaces& walls, const FieldFlight& flight);

/// Points of a flight in a field up to another of its points, to draw it, without the first and the last:
/// 256 to a full turn. Where both are one it is the full turn.
std::vector<Vec2> points_between(double field, const Ray& flight, const Vec2& to);

}  // namespace flatray
