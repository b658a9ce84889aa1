#include <fmt/core.h>

#include "base/number_text.h"
#include "scene/outlines/ring.h"
#include "scene/shape.h"

namespace flatray::convex_shape {
namespace {

constexpr KeyInfo kKeys[] = {{"points", "[[x, y] or a curve, ...]", kRequired}};

Result<Shape> build(Args& args) {
  const std::vector<Vec2> points = args.points("points");
  if (is_flat(points)) {
    args.warning(args.place("points"), "convex has no area",
                 "it is taken as the segment or point it is");
    return flat_shape(points);
  }
  if (const std::optional<std::size_t> bad = non_convex_vertex(points))
    return fail(args.place("points", *bad),
                fmt::format("not convex at vertex {}, ({}, {})", *bad,
                            number_text(points[*bad].x()), number_text(points[*bad].y())),
                "write polygon = { points = ... } for any simple outline");
  return ring_shape(points);
}

}  // namespace

extern const ShapeType entry = {"convex", kKeys, &build};

}  // namespace flatray::convex_shape
