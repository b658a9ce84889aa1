#include "scene/outlines/arcs.h"
#include "scene/shape.h"

namespace flatray::ellipse_shape {
namespace {

constexpr KeyInfo kKeys[] = {{"radii", "[a, b] or a curve", kRequired},
                             {"centre", "[x, y] or a curve", "[0, 0]"},
                             {"angle", "degrees or a curve", "0"}};

Result<Shape> build(Args& args) {
  const Vec2 radii = args.point("radii"), centre = args.point("centre");
  args.vanish(radii.x() == 0 || radii.y() == 0);
  if (!(radii.x() > 0 && radii.y() > 0))
    return fail(args.place("radii"), "ellipse.radii are not above 0",
                "write half the width and half the height");
  const Vec2 axis = unit_at_degrees(args.number("angle"));
  const EllipseArc whole{centre, radii.x() * axis, radii.y() * Vec2(-axis.y(), axis.x())};
  return shape_of(ArcPath{{whole}, true});
}

}  // namespace

extern const ShapeType entry = {"ellipse", kKeys, &build};

}  // namespace flatray::ellipse_shape
