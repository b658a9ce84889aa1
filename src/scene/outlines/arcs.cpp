#include "scene/outlines/arcs.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/number_text.h"
#include "scene/outlines/corners.h"

namespace flatray {

Vec2 unit_at_degrees(double degrees) { return corners({0, 0}, 1, degrees, {1}).front(); }

bool is_whole_turn(double from, double to) {
  return std::fabs(std::fabs(to - from) - 360) <=
         0x1p-52 * std::max({std::fabs(from), std::fabs(to), 360.0});
}

// The half-diameters are turned by `from`, so that the arc begins at t = 0.
Result<EllipseArc> circular_arc(Args& args, const Vec2& centre, double radius) {
  const double from = args.number("from"), to = args.number("to");
  args.vanish(to == from);
  const double degrees = to <= from ? to - from + 360 : is_whole_turn(from, to) ? 360 : to - from;
  if (!(degrees > 0 && degrees <= 360) || to == from)
    return fail(
        args.place("to"),
        fmt::format("from {} to {} is not part of a turn", number_text(from), number_text(to)),
        "write angles less than a turn apart, or to = from + 360 for a whole one");
  const Vec2 u = radius * unit_at_degrees(from);
  return EllipseArc{centre, u, {-u.y(), u.x()}, 0, radians(degrees)};
}

}  // namespace flatray
