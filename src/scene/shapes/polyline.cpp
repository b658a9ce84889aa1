#include "scene/outlines/ring.h"
#include "scene/shape.h"

namespace flatray::polyline_shape {
namespace {

constexpr KeyInfo kKeys[] = {{"points", "[[x, y] or a curve, ...]", kRequired},
                             {"closed", "true or false", "false"}};

// Segments that follow one another share their ends to the bit: strokes join them.
Result<Shape> build(Args& args) {
  std::vector<Vec2> points = args.points("points");
  if (args.flag("closed") && points.size() > 2) points.push_back(points.front());
  Shape shape;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    if (points[i] != points[i + 1]) shape.segments.push_back({points[i], points[i + 1]});
  if (shape.segments.empty()) return flat_shape(points);
  return shape;
}

}  // namespace

extern const ShapeType entry = {"polyline", kKeys, &build};

}  // namespace flatray::polyline_shape
