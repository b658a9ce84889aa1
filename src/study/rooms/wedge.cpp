#include "study/rooms/wedge.h"

#include <cmath>

#include "base/portable_math.h"
#include "study/rooms/wall_places.h"

namespace flatray {
namespace {

// The common point of two walls and the other end of each.
struct Wedge {
  Vec2 tip, first, second;
};

std::optional<Wedge> wedge_of(const Surfaces& walls) {
  if (walls.size() != 2 || walls.segments.size() != 2) return std::nullopt;
  const Segment &a = walls.segments[0], &b = walls.segments[1];
  for (const auto& [a0, a1] : {std::pair(a.a, a.b), std::pair(a.b, a.a)})
    for (const auto& [b0, b1] : {std::pair(b.a, b.b), std::pair(b.b, b.a)})
      if (a0 == b0) return Wedge{a0, a1, b1};
  return std::nullopt;
}

}  // namespace

// The farthest from the tip that a straight ray crosses an image of a wall: as seen from there the
// ray turns by `turn` in all, and images lie at angles from `first` to `last` of that.
double farthest_crossing(const Wedge& wedge, const Ray& ray, double turn, double first,
                         double last) {
  const double distance =
      std::fabs(cross(Vec2(ray.origin - wedge.tip), ray.direction)) / ray.direction.norm();
  return distance / std::min(portable::sin(turn - first), portable::sin(turn - last));
}

// In the unfolded wedge the ray is straight: seen from the tip, it turns from where it starts to
// where it points, over one image of a wall after another.
std::optional<std::uint64_t> wedge_reflections(const Surfaces& walls, const Ray& ray) {
  auto wedge = wedge_of(walls);
  if (!wedge) return std::nullopt;
  double alpha = turn_between(wedge->first, wedge->second, wedge->tip);
  if (alpha < 0) {
    std::swap(wedge->first, wedge->second);
    alpha = -alpha;
  }
  const Vec2 from = ray.origin - wedge->tip;
  const double here = turn_between(wedge->first, ray.origin, wedge->tip);
  if (!(alpha > 0 && here >= 0 && here <= alpha)) return std::nullopt;
  const double ahead = turn_between(from, ray.direction);
  const double turn = std::fabs(ahead), first = ahead >= 0 ? alpha - here : here;
  const double count = std::ceil((turn + alpha - first) / alpha) - 1;
  const double last = first + (count - 1) * alpha;
  const double reach =
      std::min((wedge->first - wedge->tip).norm(), (wedge->second - wedge->tip).norm());
  if (count > 0 && !(farthest_crossing(*wedge, ray, turn, first, last) < reach))
    return std::nullopt;
  return static_cast<std::uint64_t>(count);
}

}  // namespace flatray
