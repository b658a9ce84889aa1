#include "scene/outlines/arcs.h"
#include "scene/shape.h"

namespace flatray::arc_shape {
namespace {

constexpr KeyInfo kKeys[] = {{"radius", "number or a curve", kRequired},
                             {"from", "degrees or a curve", kRequired},
                             {"to", "degrees or a curve", kRequired},
                             {"centre", "[x, y] or a curve", "[0, 0]"},
                             {"chord", "true or false", "false"}};

Result<Shape> build(Args& args) {
  const Vec2 centre = args.point("centre");
  const double radius = args.size("radius");
  const bool chord = args.flag("chord");
  FLATRAY_TRY(arc, circular_arc(args, centre, radius));
  return shape_of(ArcPath{{*arc}, chord});
}

}  // namespace

extern const ShapeType entry = {"arc", kKeys, &build};

}  // namespace flatray::arc_shape
