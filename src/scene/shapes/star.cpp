#include "scene/outlines/corners.h"
#include "scene/outlines/ring.h"
#include "scene/shape.h"

namespace flatray::star_shape {
namespace {

constexpr std::int64_t kMostPoints = 1000;

constexpr KeyInfo kKeys[] = {{"points", "whole number", kRequired},
                             {"outer", "number or a curve", kRequired},
                             {"inner", "number or a curve", kRequired},
                             {"centre", "[x, y] or a curve", "[0, 0]"},
                             {"angle", "degrees or a curve", "90"}};

Result<Shape> build(Args& args) {
  const auto points = static_cast<int>(args.integer("points", 3, 3, kMostPoints));
  const Vec2 centre = args.point("centre");
  const double outer = args.size("outer"), inner = args.size("inner");
  const double angle = args.number("angle", 90);
  if (args.gone()) return Shape{};
  const std::vector<Vec2> ring = corners(centre, 2 * points, angle, {outer, inner});
  if (is_flat(ring) || crossing_edges(ring))
    return fail(args.place("outer"), "the points of the star are lost in rounding",
                "write fewer points, larger radii, or a centre nearer to 0");
  return ring_shape(ring);
}

}  // namespace

extern const ShapeType entry = {"star", kKeys, &build};

}  // namespace flatray::star_shape
