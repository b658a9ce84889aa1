#include "geom/decide.h"
#include "geom/error_bounds.h"
#include "geom/polygon.h"

namespace flatray {

Sign ring_orientation(std::span<const Vec2> ring) {
  if (ring.size() < 3) return Sign::zero;
  const Vec2& apex = ring[0];
  // Twice the area as a fan about vertex 0. Filter: every product is good to kDetFilter, and each
  // of n additions loses at most u of what has been summed up to then.
  double area = 0, size = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const double left = (ring[i].x() - apex.x()) * (ring[i + 1].y() - apex.y());
    const double right = (ring[i].y() - apex.y()) * (ring[i + 1].x() - apex.x());
    area += left - right;
    size += std::fabs(left) + std::fabs(right);
  }
  const double n = static_cast<double>(ring.size());
  if (size >= kDetFilterLeast * n && std::fabs(area) > (kDetFilter + kSumFilter * n) * size)
    return sign_of(area);
  return decide([&](const auto& number) {
    auto sum = number(0.0);
    for (std::size_t i = 1; i + 1 < ring.size(); ++i)
      sum = sum + determinant(number, apex, ring[i], apex, ring[i + 1]);
    return sum;
  });
}

}  // namespace flatray
