#include "collide/broad_phase.h"

#include <algorithm>
#include <cmath>

namespace flatray {
namespace {

constexpr std::int64_t kMostCells = 64;     // that one box is put into
constexpr std::int64_t kMostAcross = 1024;  // of the grid

double width_of(const Bounds& box) { return box.size().maxCoeff(); }

}  // namespace

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

BoxCells::BoxCells(std::span<const Bounds> boxes) {
  std::vector<double> widths;
  for (const Bounds& box : boxes)
    if (!box.empty()) widths.push_back(width_of(box));
  const auto middle = widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 2);
  if (!widths.empty()) std::nth_element(widths.begin(), middle, widths.end());
  if (!widths.empty() && *middle > 0 && *middle < kInfinity) width_ = *middle;
  std::int64_t across = 1;
  while (across < kMostAcross && across * across < static_cast<std::int64_t>(widths.size()))
    across *= 2;
  mask_ = across - 1;
  first_.assign(static_cast<std::size_t>(across * across), kNone);
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    if (!boxes[i].empty()) add(i, boxes[i]);
}

void BoxCells::add(std::uint32_t number, const Bounds& box) {
  const auto cells = cells_of(box);
  if (!cells) {
    large_.push_back(number);
    return;
  }
  for (std::int64_t y = cells->low_y; y <= cells->high_y; ++y)
    for (std::int64_t x = cells->low_x; x <= cells->high_x; ++x) {
      std::uint32_t& first = first_[slot(x, y)];
      entries_.push_back({number, first});
      first = static_cast<std::uint32_t>(entries_.size() - 1);
    }
}

std::optional<BoxCells::Cells> BoxCells::cells_of(const Bounds& box) const {
  constexpr double kMost = 0x1p52;  // cells from the origin that are counted one by one
  const Vec2 low = box.low / width_, high = box.high / width_;
  for (int axis = 0; axis < 2; ++axis)
    if (!(low[axis] > -kMost && high[axis] < kMost)) return std::nullopt;
  const auto cell = [](double place) { return static_cast<std::int64_t>(std::floor(place)); };
  const Cells cells{cell(low.x()), cell(high.x()), cell(low.y()), cell(high.y())};
  const std::int64_t wide = cells.high_x - cells.low_x + 1, tall = cells.high_y - cells.low_y + 1;
  if (wide > kMostCells || tall > kMostCells || wide * tall > kMostCells) return std::nullopt;
  return cells;
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
