#include "transport/light/order.h"

#include <array>
#include <numeric>

namespace flatray {

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
