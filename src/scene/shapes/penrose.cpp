#include "scene/outlines/arcs.h"
#include "scene/shape.h"

namespace flatray::penrose_shape {
namespace {

constexpr KeyInfo kKeys[] = {{"size", "number or a curve", kRequired},
                             {"centre", "[x, y] or a curve", "[0, 0]"}};

// L. and R. Penrose 1958: a ray that passes between the foci of a half ellipse comes back between
// them, one that passes beside them beside them. So whatever the place of a lamp, some of the four
// alcoves beside the foci stay dark. Half-diameters 5 and 3 have their foci at 4: all corners are
// whole numbers.
Result<Shape> build(Args& args) {
  const Vec2 centre = args.point("centre");
  const double unit = args.size("size");
  const auto at = [&](double x, double y) { return Vec2(centre + unit * Vec2(x, y)); };
  const auto corner = [&](double x, double y) { return corner_at(at(x, y)); };
  const Vec2 along(5 * unit, 0), up(0, 3 * unit);
  constexpr double kHalf = std::numbers::pi;
  return shape_of(ArcPath{{{at(0, 3), along, up, 0, kHalf},
                           corner(-5, 1),
                           corner(-4, 3),
                           corner(-3, 0),
                           corner(-4, -3),
                           corner(-5, -1),
                           {at(0, -3), along, up, kHalf, kHalf},
                           corner(5, -1),
                           corner(4, -3),
                           corner(3, 0),
                           corner(4, 3),
                           corner(5, 1)},
                          true});
}

}  // namespace

extern const ShapeType entry = {"penrose", kKeys, &build};

}  // namespace flatray::penrose_shape
