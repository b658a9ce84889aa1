#include "study/wall_places.h"

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"

namespace flatray {
namespace {

constexpr double kTurn = 0x1.921fb54442d18p+2;

bool is_circle(const Surfaces& walls, std::uint32_t surface) {
  return walls.kinds[surface] == SurfaceKind::circle;
}
const Circle& circle(const Surfaces& walls, std::uint32_t surface) {
  return walls.circles[walls.slot[surface]];
}
const Segment& segment(const Surfaces& walls, std::uint32_t surface) {
  return walls.segments[walls.slot[surface]];
}
double length(const Vec2& v) { return std::sqrt(v.x() * v.x() + v.y() * v.y()); }

}  // namespace

double wall_length(const Surfaces& walls, std::uint32_t surface) {
  if (is_circle(walls, surface)) return kTurn * circle(walls, surface).radius;
  const Segment& wall = segment(walls, surface);
  return length(wall.b - wall.a);
}

Vec2 wall_point(const Surfaces& walls, std::uint32_t surface, double position) {
  if (is_circle(walls, surface)) {
    const Circle& wall = circle(walls, surface);
    const double angle = position / wall.radius;
    return wall.centre + wall.radius * Vec2(portable::cos(angle), portable::sin(angle));
  }
  const Segment& wall = segment(walls, surface);
  return wall.a + position / wall_length(walls, surface) * (wall.b - wall.a);
}

double wall_position(const Surfaces& walls, std::uint32_t surface, const Vec2& point) {
  if (is_circle(walls, surface)) {
    const Circle& wall = circle(walls, surface);
    const Vec2 from = point - wall.centre;
    const double angle = portable::atan2(from.y(), from.x());
    return wall.radius * (angle < 0 ? angle + kTurn : angle);
  }
  return std::min(length(point - segment(walls, surface).a), wall_length(walls, surface));
}

Vec2 wall_normal(const Surfaces& walls, std::uint32_t surface, const Vec2& point) {
  if (is_circle(walls, surface)) {
    const Vec2 out = point - circle(walls, surface).centre;
    return out / length(out);
  }
  const Segment& wall = segment(walls, surface);
  const Vec2 edge = wall.b - wall.a;
  return Vec2(-edge.y(), edge.x()) / length(edge);
}

double curvature(const Surfaces& walls, std::uint32_t surface, const Vec2& point,
                 const Vec2& normal) {
  if (!is_circle(walls, surface)) return 0;
  const Circle& wall = circle(walls, surface);
  return ((point - wall.centre).dot(normal) > 0 ? 1 : -1) / wall.radius;
}

}  // namespace flatray
