#include <algorithm>
#include <cmath>

#include "geom/predicates.h"
#include "scene/shape.h"

namespace flatray::cell_shape {
namespace {

constexpr KeyInfo kKeys[] = {{"a", "[x, y] or a curve", kRequired},
                             {"b", "[x, y] or a curve", kRequired},
                             {"sides", "4 or 6", "4"}};

// The point as far from 0 as from a and from b.
Vec2 circumcentre(const Vec2& a, const Vec2& b) {
  const double twice = 2 * cross(a, b), aa = a.dot(a), bb = b.dot(b);
  return {(aa * b.y() - bb * a.y()) / twice, (bb * a.x() - aa * b.x()) / twice};
}

// Round the origin, with opposite corners each other's negatives: so opposite edges are the same exactly,
// whatever was rounded. Edge 1 lies towards a, edge 2 towards b.
Result<Shape> build(Args& args) {
  const Vec2 a = args.point("a"), b = args.point("b");
  const auto sides = args.integer("sides", 4, 4, 6);
  if (sides == 5) args.problem("sides", "is 5", "write 4 or 6");
  args.vanish(cross_sign(a, b) == Sign::zero);
  if (args.gone()) return Shape{};
  if (cross_sign(a, b) != Sign::positive)
    return fail(args.where, "the cell has no area, or is turned over",
                "b must lie to the left of a: swap them");
  std::vector<Vec2> half;
  if (sides == 4) {
    half = {-0.5 * a - 0.5 * b, 0.5 * a - 0.5 * b};
  } else {
    // A power of two: in it squares are doubles, and nothing else is rounded.
    const double unit =
        std::ldexp(1.0, std::ilogb(std::max(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff())));
    const Vec2 one = a / unit, other = b / unit, across = other - one;
    if (!(one.dot(other) > 0 && one.dot(across) < 0 && other.dot(across) > 0))
      return fail(args.where,
                  "a cell of six sides needs 0, a and b to be corners of an acute triangle",
                  "write 4 sides, or lattice vectors about 60 degrees apart");
    half = {-unit * circumcentre(other, across), -unit * circumcentre(across, -one),
            unit * circumcentre(one, other)};
  }
  Shape shape;
  shape.vertices = half;
  for (const Vec2& corner : half) shape.vertices.push_back(-corner);
  const auto count = static_cast<std::uint32_t>(shape.vertices.size());
  shape.begin = {0, count};
  for (std::uint32_t i = 0; i < count; ++i) {
    shape.edges.push_back(static_cast<std::int32_t>(i));
    if (orientation(shape.vertices[i], shape.vertices[(i + 1) % count],
                    shape.vertices[(i + 2) % count]) != Sign::positive)
      return fail(args.where, "the sides of the cell are lost in rounding",
                  "write vectors more apart");
  }
  return shape;
}

}  // namespace

extern const ShapeType entry = {"cell", kKeys, &build, true};

}  // namespace flatray::cell_shape
