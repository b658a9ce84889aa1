#include "scene/shape.h"

namespace flatray::segment_shape {
namespace {

constexpr KeyInfo kKeys[] = {{"from", "[x, y] or a curve", kRequired},
                             {"to", "[x, y] or a curve", kRequired}};

Result<Shape> build(Args& args) {
  const Segment segment{args.point("from"), args.point("to")};
  if (segment.a == segment.b) return Shape{.circles = {{segment.a, 0}}};
  return Shape{.segments = {segment}};
}

}  // namespace

extern const ShapeType entry = {"segment", kKeys, &build};

}  // namespace flatray::segment_shape
