#include "collide/broad_phase.h"

#include <algorithm>

namespace flatray {

std::vector<std::pair<std::uint32_t, std::uint32_t>> overlapping_pairs(
    std::span<const Bounds> boxes) {
  std::vector<std::uint32_t> by_left;
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    if (!boxes[i].empty()) by_left.push_back(i);
  std::sort(by_left.begin(), by_left.end(),
            [&](std::uint32_t i, std::uint32_t k) { return boxes[i].low.x() < boxes[k].low.x(); });
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::size_t i = 0; i < by_left.size(); ++i) {
    const Bounds& a = boxes[by_left[i]];
    for (std::size_t k = i + 1; k < by_left.size(); ++k) {
      const Bounds& b = boxes[by_left[k]];
      if (b.low.x() > a.high.x()) break;
      if (a.low.y() <= b.high.y() && b.low.y() <= a.high.y())
        pairs.push_back(std::minmax(by_left[i], by_left[k]));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

Bounds swept(const Bounds& box, const Vec2& velocity, double length) {
  if (box.empty()) return box;
  Bounds all = box;
  const Vec2 way = velocity * length;
  all.add(box.low + way);
  all.add(box.high + way);
  // A product and a sum, each off by half an ulp of what goes in.
  constexpr double kUlps = 0x1p-51;
  const Vec2 room = kUlps * (all.low.cwiseAbs().cwiseMax(all.high.cwiseAbs()) + way.cwiseAbs());
  all.low -= room;
  all.high += room;
  return all;
}

}  // namespace flatray
