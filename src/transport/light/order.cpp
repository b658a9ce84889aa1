#include "transport/light/order.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace flatray {
namespace {

// Rises from 0 to 1 as `v` turns once; by its components alone.
double turn_share(const Vec2& v) {
  const double part = v.y() / (std::fabs(v.x()) + std::fabs(v.y()));
  return v.x() < 0 ? (2 - part) / 4 : v.y() < 0 ? (4 + part) / 4 : part / 4;
}

double share_along(const Arc& wall, const Vec2& point) {
  return turn_share(point - wall.curve.centre);
}

double share_along(const Bezier& wall, const Vec2& point) { return parameter_near(wall, point); }

}  // namespace

double share_along(const Segment& wall, const Vec2& point) {
  const Vec2 along = wall.b - wall.a;
  const int axis = std::fabs(along.x()) >= std::fabs(along.y()) ? 0 : 1;
  return (point[axis] - wall.a[axis]) / along[axis];
}

WallPlace wall_place(const Surfaces& walls, std::uint32_t surface, const Vec2& point) {
  const double share =
      walls.visit(surface, [&](const auto& wall) { return share_along(wall, point); });
  const double held = share > 0 ? std::min(share, 1 - 0x1p-32) : 0;  // NaN: 0
  return (WallPlace{surface} << 32) | static_cast<std::uint32_t>(held * 0x1p32);
}

std::vector<std::uint32_t> ascending_order(std::span<const WallPlace> places) {
  struct Item {
    WallPlace place;
    std::uint32_t number;
  };
  constexpr unsigned kDigitBits = 11;  // at a time
  std::vector<Item> items(places.size()), sorted(places.size());
  WallPlace same = ~WallPlace{0}, any = 0;
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    items[i] = {places[i], i};
    same &= places[i], any |= places[i];
  }
  for (unsigned shift = 0; shift < 64; shift += kDigitBits) {
    const auto digit = [&](WallPlace place) { return (place >> shift) & ((1U << kDigitBits) - 1); };
    if (digit(same ^ any) == 0) continue;
    std::array<std::uint32_t, (1U << kDigitBits) + 1> begin{};
    for (const Item& item : items) ++begin[digit(item.place) + 1];
    for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
    for (const Item& item : items) sorted[begin[digit(item.place)]++] = item;
    items.swap(sorted);
  }
  std::vector<std::uint32_t> order(places.size());
  for (std::size_t i = 0; i < items.size(); ++i) order[i] = items[i].number;
  return order;
}

}  // namespace flatray
