#include "geom/primitives/bezier.h"

#include "scene/shape.h"

namespace flatray::bezier_shape {
namespace {

constexpr KeyInfo kKeys[] = {{"points", "[[x, y] or a curve, ...]", kRequired},
                             {"degree", "2 or 3", "3"}};

// Curves that follow one another share their ends to the bit: strokes join them.
Result<Shape> build(Args& args) {
  const auto degree = static_cast<std::size_t>(args.integer("degree", 3, 2, 3));
  const std::vector<Vec2> points = args.points("points");
  Shape shape;
  if (args.gone()) return shape;
  if (points.size() <= degree || (points.size() - 1) % degree != 0)
    return fail(args.place("points"),
                "the control points of the bezier are not a whole number of curves",
                degree == 2 ? "write 3 of them, and 2 more for each further curve"
                            : "write 4 of them, and 3 more for each further curve");
  for (std::size_t i = 0; i + 1 < points.size(); i += degree) {
    const Bezier curve(std::span<const Vec2>(points).subspan(i, degree + 1));
    if (is_on_one_line(curve))
      return fail(args.place("points"), "the control points of a curve lie on one line",
                  "bend it, or draw it as a segment");
    shape.beziers.push_back(curve);
  }
  return shape;
}

}  // namespace

extern const ShapeType entry = {"bezier", kKeys, &build};

}  // namespace flatray::bezier_shape
