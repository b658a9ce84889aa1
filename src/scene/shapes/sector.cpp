#include "scene/outlines/arcs.h"
#include "scene/shape.h"

namespace flatray::sector_shape {
namespace {

constexpr KeyInfo kKeys[] = {{"radius", "number or a curve", kRequired},
                             {"from", "degrees or a curve", kRequired},
                             {"to", "degrees or a curve", kRequired},
                             {"centre", "[x, y] or a curve", "[0, 0]"},
                             {"inner", "number or a curve", "0"}};

// The outer arc, and back along the inner one: at radius 0 a corner.
Result<Shape> build(Args& args) {
  const Vec2 centre = args.point("centre");
  const double radius = args.size("radius"), inner = args.number("inner");
  const Result<EllipseArc> outer = circular_arc(args, centre, radius);
  args.vanish(inner == radius);
  if (!outer) return tl::unexpected(outer.error());
  if (!(inner >= 0 && inner < radius))
    return fail(args.place("inner"), "sector.inner does not lie between 0 and the radius",
                "write a smaller radius, or leave it out");
  if (inner == 0 && outer->is_whole()) return shape_of(ArcPath{{*outer}, true});
  EllipseArc back = *outer;
  const double share = inner / radius;
  back.u *= share, back.v *= share;
  back.from = outer->from + outer->sweep;
  back.sweep = -outer->sweep;
  return shape_of(ArcPath{{*outer, back}, true});
}

}  // namespace

extern const ShapeType entry = {"sector", kKeys, &build};

}  // namespace flatray::sector_shape
