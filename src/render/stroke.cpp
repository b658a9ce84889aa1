#include "render/stroke.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/portable_math.h"

namespace flatray {
namespace {

// Chords of a half circle that keep within the sagitta: r (1 - cos(angle / 2)) <= r angle^2 / 8.
int half_circle_chords(double radius) {
  const double angle = std::sqrt(8 * kCapSagitta_px / radius);
  return static_cast<int>(std::clamp(std::ceil(std::numbers::pi / angle), 4.0, 4096.0));
}

}  // namespace

void add_capsule(const Segment& segment, double half_width, std::vector<Segment>& edges) {
  const Vec2 along = segment.b - segment.a;
  const double length = std::sqrt(along.squaredNorm());
  const Vec2 unit = length > 0 ? Vec2(along / length) : Vec2(1, 0);
  const Vec2 side = half_width * Vec2(unit.y(), -unit.x());

  const int chords = half_circle_chords(half_width);
  const Vec2 first = segment.b + side;
  Vec2 last = first;
  const auto go_to = [&](const Vec2& point) {
    if (point != last) edges.push_back({last, point});
    last = point;
  };
  const auto half_circle = [&](const Vec2& centre, const Vec2& from) {
    const Vec2 ahead(-from.y(), from.x());
    for (int i = 1; i < chords; ++i) {
      const double angle = std::numbers::pi * i / chords;
      go_to(centre + portable::cos(angle) * from + portable::sin(angle) * ahead);
    }
    go_to(centre - from);
  };
  half_circle(segment.b, side);
  go_to(segment.a - side);
  half_circle(segment.a, -side);
  go_to(first);
}

}  // namespace flatray
