#include "trace/on_surface.h"

#include <algorithm>

#include "geom/decide.h"

namespace flatray {

bool lies_on(const Vec2& point, const Segment& segment) {
  const auto between = [&](int axis) {
    const auto [low, high] = std::minmax(segment.a[axis], segment.b[axis]);
    return low <= point[axis] && point[axis] <= high;
  };
  return between(0) && between(1) && orientation(segment.a, segment.b, point) == Sign::zero;
}

Sign circle_side(const Vec2& point, const Circle& circle) {
  return decide([&](auto number) {
    const auto x = number(point.x()) - number(circle.centre.x());
    const auto y = number(point.y()) - number(circle.centre.y());
    const auto r = number(circle.radius);
    return x * x + y * y - r * r;
  });
}

}  // namespace flatray
