#include "study/rooms/free_circles.h"

#include <algorithm>
#include <cmath>

namespace flatray {
namespace {

constexpr int kRows = 16384;

// How near and how far the points of a wall are.
struct Reach {
  double least, most;
};
Reach reach_of(const Segment& wall, const Vec2& place) {
  const Vec2 edge = wall.b - wall.a;
  const double along = std::clamp((place - wall.a).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
  return {(place - (wall.a + along * edge)).norm(),
          std::max((place - wall.a).norm(), (place - wall.b).norm())};
}
Reach reach_of(const Arc& wall, const Vec2& place) {
  const Vec2& centre = wall.curve.centre;
  const double away = (place - centre).norm(), radius = wall.curve.u.x();
  Reach reach{std::fabs(away - radius), away + radius};
  if (wall.extent == Arc::Extent::whole) return reach;
  const double from = (place - wall.from).norm(), to = (place - wall.to).norm();
  if (place_in_cone(wall, place) == PlaceOn::outside) reach.least = std::min(from, to);
  if (place_in_cone(wall, Vec2(2 * centre - place)) == PlaceOn::outside)
    reach.most = std::max(from, to);
  return reach;
}
Reach reach_of(const Bezier&, const Vec2&) { return {0, kInfinity}; }  // of no room with a field

// The places of a row at which circles about them may begin or cease to meet a wall.
class Changes {
 public:
  explicit Changes(double row) : row_(row) {}

  void add(const Segment& wall, double radius) {
    const Vec2 edge = wall.b - wall.a;
    const Vec2 across = radius / std::sqrt(edge.squaredNorm()) * Vec2(-edge.y(), edge.x());
    for (const Vec2& side : {across, Vec2(-across)}) add_line(wall.a + side, edge);
    for (const Vec2& end : {wall.a, wall.b}) add_circle(end, radius);
  }
  void add(const Arc& wall, double radius) {
    const Vec2& centre = wall.curve.centre;
    for (const double side : {radius, -radius}) add_circle(centre, wall.curve.u.x() + side);
    if (wall.extent == Arc::Extent::whole) return;
    for (const Vec2& end : {wall.from, wall.to}) {
      add_circle(end, radius);
      add_line(centre, end - centre);
    }
  }
  void add(const Bezier&, double) {}

  std::vector<double> sorted() && {
    std::ranges::sort(places_);
    return std::move(places_);
  }

 private:
  void add_circle(const Vec2& centre, double radius) {
    const double up = row_ - centre.y(), square = (radius - up) * (radius + up);
    if (square <= 0) return;
    places_.push_back(centre.x() - std::sqrt(square));
    places_.push_back(centre.x() + std::sqrt(square));
  }
  void add_line(const Vec2& through, const Vec2& along) {
    if (along.y() != 0)
      places_.push_back(through.x() + (row_ - through.y()) / along.y() * along.x());
  }

  double row_;
  std::vector<double> places_;
};

bool is_free(const Room& room, const Vec2& centre, double radius) {
  const Surfaces& walls = room.walls();
  for (std::uint32_t i = 0; i < walls.size(); ++i) {
    const Reach reach = walls.visit(i, [&](const auto& wall) { return reach_of(wall, centre); });
    if (reach.least <= radius && radius <= reach.most) return false;
  }
  const Vec2 point = centre + Vec2(radius, 0);  // of a circle that crosses no wall
  return room.solids().in_chamber(point) && !room.solids().holder(point);
}

}  // namespace

double area_of_free_centres(const Room& room, double radius) {
  const Surfaces& walls = room.walls();
  const Bounds box = bounds_of(walls);
  const double height = box.size().y() / kRows;
  double length = 0;
  for (int row = 0; row < kRows; ++row) {
    const double y = box.low.y() + (row + 0.5) * height;
    Changes changes(y);
    for (std::uint32_t i = 0; i < walls.size(); ++i)
      walls.visit(i, [&](const auto& wall) { changes.add(wall, radius); });
    const std::vector<double> places = std::move(changes).sorted();
    for (std::size_t i = 1; i < places.size(); ++i)
      if (places[i] > places[i - 1] &&
          is_free(room, {0.5 * (places[i - 1] + places[i]), y}, radius))
        length += places[i] - places[i - 1];
  }
  return length * height;
}

double most_off_of_free_centres(const Room& room) {
  return 1e-4 * bounds_of(room.walls()).size().prod();
}

}  // namespace flatray
