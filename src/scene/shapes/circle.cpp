#include <fmt/core.h>

#include "base/number_text.h"
#include "scene/shape.h"

namespace flatray::circle_shape {
namespace {

constexpr KeyInfo kKeys[] = {{"radius", "number or a curve", kRequired},
                             {"centre", "[x, y] or a curve", "[0, 0]"}};

Result<Shape> build(Args& args) {
  const Circle circle{args.point("centre"), args.number("radius")};
  if (circle.radius < 0)
    return fail(args.place("radius"),
                fmt::format("circle has a radius of {}", number_text(circle.radius)),
                "it must be at least 0; 0 is a point");
  return Shape{.circles = {circle}};
}

}  // namespace

extern const ShapeType entry = {"circle", kKeys, &build};

}  // namespace flatray::circle_shape
