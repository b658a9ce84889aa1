#include "scene/outlines/corners.h"

#include <cmath>
#include <span>

#include "base/portable_math.h"
#include "scene/reading/reader.h"

namespace flatray {
namespace {

// Unit vector at `quarters` quarter turns and `degrees`. What is a whole quarter is turned exactly.
Vec2 unit_at(int quarters, double degrees) {
  const double more = std::floor(degrees / 90);
  const double rest = degrees - 90 * more;
  const Vec2 unit =
      rest == 0 ? Vec2(1, 0) : Vec2(portable::cos(radians(rest)), portable::sin(radians(rest)));
  switch ((quarters + static_cast<int>(more - 4 * std::floor(more / 4))) % 4) {
    case 0:
      return unit;
    case 1:
      return {-unit.y(), unit.x()};
    case 2:
      return -unit;
    default:
      return {unit.y(), -unit.x()};
  }
}

}  // namespace

std::vector<Vec2> corners(const Vec2& centre, int count, double degrees,
                          std::initializer_list<double> radii) {
  const std::span<const double> distances(radii.begin(), radii.size());
  std::vector<Vec2> points;
  for (int i = 0; i < count; ++i) {
    const int quarters = 4 * i / count, rest = 4 * i % count;
    const double from_quarter = degrees + 90.0 * rest / count;
    const double radius = distances[static_cast<std::size_t>(i) % distances.size()];
    points.push_back(centre + radius * unit_at(quarters, from_quarter));
  }
  return points;
}

}  // namespace flatray
