
#include "scene/outlines/corners.h"
#include "scene/outlines/ring.h"
#include "scene/shape.h"

namespace flatray::ngon_shape {
namespace {

constexpr std::int64_t kMostSides = 10'000;

constexpr KeyInfo kKeys[] = {{"sides", "whole number", kRequired},
                             {"radius", "number or a curve", kRequired},
                             {"centre", "[x, y] or a curve", "[0, 0]"},
                             {"angle", "degrees or a curve", "90"}};

Result<Shape> build(Args& args) {
  const auto sides = static_cast<int>(args.integer("sides", 3, 3, kMostSides));
  const Vec2 centre = args.point("centre");
  const double radius = args.size("radius");
  const double angle = args.number("angle", 90);
  if (args.gone()) return Shape{};
  const std::vector<Vec2> points = corners(centre, sides, angle, {radius});
  if (non_convex_vertex(points) || clean_ring(points).vertices.size() != points.size())
    return fail(args.place("radius"), "the sides of the ngon are lost in rounding",
                "write fewer sides, a larger radius, or a centre nearer to 0");
  return ring_shape(points);
}

}  // namespace

extern const ShapeType entry = {"ngon", kKeys, &build};

}  // namespace flatray::ngon_shape
