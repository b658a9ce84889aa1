#include "scene/outlines/arcs.h"
#include "scene/shape.h"

namespace flatray::mushroom_shape {
namespace {

constexpr KeyInfo kKeys[] = {{"radius", "number or a curve", kRequired},
                             {"width", "number or a curve", kRequired},
                             {"height", "number or a curve", kRequired},
                             {"centre", "[x, y] or a curve", "[0, 0]"}};

// Bunimovich 2001: orbits that stay in the cap are regular, those that come to the stem chaotic.
Result<Shape> build(Args& args) {
  const Vec2 centre = args.point("centre");
  const double radius = args.size("radius"), half = 0.5 * args.size("width");
  const double height = args.size("height");
  if (!(half < radius))
    return fail(args.place("width"), "the stem is as wide as the cap",
                "write a width below 2 radius; of equal ones make a capsule or an arc");
  const auto corner = [&](double x, double y) { return corner_at(centre + Vec2(x, y)); };
  const EllipseArc cap{centre, {radius, 0}, {0, radius}, 0, std::numbers::pi};
  return shape_of(ArcPath{
      {cap, corner(-half, 0), corner(-half, -height), corner(half, -height), corner(half, 0)},
      true});
}

}  // namespace

extern const ShapeType entry = {"mushroom", kKeys, &build};

}  // namespace flatray::mushroom_shape
