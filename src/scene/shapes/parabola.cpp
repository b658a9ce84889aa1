#include "geom/primitives/bezier.h"
#include "scene/shape.h"

namespace flatray::parabola_shape {
namespace {

constexpr KeyInfo kKeys[] = {{"vertex", "[x, y] or a curve", kRequired},
                             {"focus", "[x, y] or a curve", kRequired},
                             {"width", "number or a curve", kRequired}};

// With a to the focus, at the distance w from the axis the curve is w^2 / (4 |a|) ahead of its vertex; the
// tangents at both ends cross as far behind it.
Result<Shape> build(Args& args) {
  const Vec2 vertex = args.point("vertex"), focus = args.point("focus");
  const double half = 0.5 * args.size("width");
  if (args.gone()) return Shape{};
  const Vec2 axis = focus - vertex;
  const double length = axis.stableNorm();
  const Vec2 across = half / length * Vec2(-axis.y(), axis.x());
  const Vec2 ahead = half / (2 * length) * (half / (2 * length)) * axis;
  const Bezier curve(vertex + ahead - across, vertex - ahead, vertex + ahead + across);
  const bool is_finite = (ahead.cwiseAbs() + across.cwiseAbs()).maxCoeff() < kFarthest;
  if (!is_finite || is_on_one_line(curve))
    return fail(args.place("focus"), "the parabola is too flat, or its focus is its vertex",
                "write a focus apart from the vertex, about as far from it as the width is large");
  return Shape{.beziers = {curve}};
}

}  // namespace

extern const ShapeType entry = {"parabola", kKeys, &build, true};

}  // namespace flatray::parabola_shape
