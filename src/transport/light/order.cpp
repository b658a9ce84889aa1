#include "transport/light/order.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace flatray {
namespace {

// Rises from 0 to 1 as `v` turns once; by its components alone.
double turn_share(const Vec2& v) {
  const double part = v.y() / (std::fabs(v.x()) + std::fabs(v.y()));
  return v.x() < 0 ? (2 - part) / 4 : v.y() < 0 ? (4 + part) / 4 : part / 4;
}

}  // namespace

double share_along(const Surfaces& walls, std::uint32_t surface, const Vec2& point) {
  const Segment& wall = walls.segments[walls.slot[surface]];
  const Vec2 along = wall.b - wall.a;
  const int axis = std::fabs(along.x()) >= std::fabs(along.y()) ? 0 : 1;
  return (point[axis] - wall.a[axis]) / along[axis];
}

WallPlace wall_place(const Surfaces& walls, std::uint32_t surface, const Vec2& point) {
  const double share = walls.is_straight(surface) ? share_along(walls, surface, point)
                                                  : turn_share(point - walls.curve(surface).centre);
  const double held = share > 0 ? std::min(share, 1 - 0x1p-32) : 0;  // NaN: 0
  return (WallPlace{surface} << 32) | static_cast<std::uint32_t>(held * 0x1p32);
}

std::vector<std::uint32_t> ascending_order(std::span<const WallPlace> places) {
  std::vector<std::uint32_t> order(places.size()), sorted(places.size());
  std::iota(order.begin(), order.end(), 0U);
  WallPlace same = ~WallPlace{0}, any = 0;
  for (const WallPlace place : places) same &= place, any |= place;
  for (unsigned shift = 0; shift < 64; shift += 8) {
    if ((((same ^ any) >> shift) & 0xff) == 0) continue;
    std::array<std::uint32_t, 257> begin{};
    for (const WallPlace place : places) ++begin[((place >> shift) & 0xff) + 1];
    for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
    for (const std::uint32_t i : order) sorted[begin[(places[i] >> shift) & 0xff]++] = i;
    order.swap(sorted);
  }
  return order;
}

}  // namespace flatray
