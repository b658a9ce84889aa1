#include "scene/outlines/ring.h"
#include "scene/shape.h"

namespace flatray::box_shape {
namespace {

constexpr KeyInfo kKeys[] = {{"min", "[x, y] or a curve", kRequired},
                             {"max", "[x, y] or a curve", kRequired}};

Result<Shape> build(Args& args) {
  const Vec2 low = args.point("min"), high = args.point("max");
  args.vanish(low.x() == high.x() || low.y() == high.y());
  if (!(low.x() < high.x() && low.y() < high.y()))
    return fail(args.where, "box has no area", "min must lie below and left of max");
  return Shape{.vertices = {low, {high.x(), low.y()}, high, {low.x(), high.y()}},
               .begin = {0, 4},
               .edges = {0, 1, 2, 3}};
}

}  // namespace

extern const ShapeType entry = {"box", kKeys, &build};

}  // namespace flatray::box_shape
