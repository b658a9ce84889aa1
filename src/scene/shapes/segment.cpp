#include "scene/outlines/ring.h"
#include "scene/shape.h"

namespace flatray::segment_shape {
namespace {

constexpr KeyInfo kKeys[] = {{"from", "[x, y] or a curve", kRequired},
                             {"to", "[x, y] or a curve", kRequired}};

Result<Shape> build(Args& args) {
  const Segment segment{args.point("from"), args.point("to")};
  Shape shape;
  if (segment.a == segment.b)
    add_flat(shape, std::vector{segment.a});
  else
    shape.segments.push_back(segment);
  return shape;
}

}  // namespace

extern const ShapeType entry = {"segment", kKeys, &build};

}  // namespace flatray::segment_shape
