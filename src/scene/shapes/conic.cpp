#include <fmt/core.h>

#include <cmath>

#include "geom/primitives/bezier.h"
#include "scene/shape.h"

namespace flatray::conic_shape {
namespace {

constexpr KeyInfo kKeys[] = {{"vertex", "[x, y] or a curve", kRequired},
                             {"focus", "[x, y] or a curve", kRequired},
                             {"width", "number or a curve", kRequired},
                             {"eccentricity", "number or a curve", "1"}};

// With f to the focus, h half of the width and e the eccentricity the curve of radius r = f (1 + e) at its vertex is
// h^2 / (r (1 + w)) ahead there, and the tangents at its ends cross h^2 / (r w (1 + w)) behind, where
// w^2 = 1 - (1 - e^2) h^2 / r^2 is its weight.
Result<Shape> build(Args& args) {
  const Vec2 vertex = args.point("vertex"), focus = args.point("focus");
  const double half = 0.5 * args.size("width"), e = args.number("eccentricity", 1);
  if (args.gone()) return Shape{};
  if (e < 0)
    return fail(
        args.place("eccentricity"), "the eccentricity is below 0",
        "write 0 for a circle, less than 1 for an ellipse, 1 for a parabola, more for a hyperbola");
  const Vec2 axis = focus - vertex;
  const double length = axis.stableNorm(), share = half / length;
  const double square = 1 - (1 - e) / (1 + e) * share * share;
  if (square <= 0 && length > 0)
    return fail(args.place("width"), "the conic is as wide as the whole ellipse, or wider",
                fmt::format("write less than {:.6g}", 2 * length * std::sqrt((1 + e) / (1 - e))));
  const double weight = std::sqrt(square);
  const Vec2 across = share * Vec2(-axis.y(), axis.x());
  const Vec2 ahead = share * share / ((1 + e) * (1 + weight)) * axis;
  const Bezier curve(vertex + ahead - across, vertex - ahead / weight, vertex + ahead + across,
                     weight);
  const bool is_finite = (ahead.cwiseAbs() / weight + across.cwiseAbs()).maxCoeff() < kFarthest;
  if (!is_finite || !Bezier::is_in_range(weight) || is_on_one_line(curve))
    return fail(
        args.place("focus"), "the conic is too flat, or its focus is its vertex",
        "write a focus apart from the vertex, about as far from it as the width is large, and a "
        "small eccentricity");
  return Shape{.beziers = {curve}};
}

}  // namespace

extern const ShapeType entry = {"conic", kKeys, &build, true};

}  // namespace flatray::conic_shape
