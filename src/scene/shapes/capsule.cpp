#include "scene/outlines/arcs.h"
#include "scene/shape.h"

namespace flatray::capsule_shape {
namespace {

constexpr KeyInfo kKeys[] = {{"from", "[x, y] or a curve", kRequired},
                             {"to", "[x, y] or a curve", kRequired},
                             {"radius", "number or a curve", kRequired}};

// Two half circles; the sides are the lines that join them. As walls: two arcs and two segments that
// share their ends, which are corners (docs/adr/0014-curved-walls.md).
Result<Shape> build(Args& args) {
  const Vec2 from = args.point("from"), to = args.point("to");
  const double radius = args.size("radius");
  if (from == to) return Shape{.circles = {{from, radius}}};
  const Vec2 way = to - from;  // longer or shorter than its square has room for
  const Vec2 short_way = way / way.cwiseAbs().maxCoeff();
  const Vec2 ahead = radius * (short_way / std::sqrt(short_way.squaredNorm()));
  const Vec2 right(ahead.y(), -ahead.x());
  const EllipseArc far{to, right, ahead, 0, std::numbers::pi};
  const EllipseArc near{from, -right, -ahead, 0, std::numbers::pi};
  return shape_of(ArcPath{{far, near}, true, radius});
}

}  // namespace

extern const ShapeType entry = {"capsule", kKeys, &build};

}  // namespace flatray::capsule_shape
