#include "collide/broad_phase.h"

#include <algorithm>
#include <cmath>

namespace flatray {
namespace {

constexpr std::int64_t kMostCells = 64;     // that one box is put into
constexpr std::int64_t kMostAcross = 1024;  // of the grid

double width_of(const Bounds& box) { return box.size().maxCoeff(); }

// Of two boxes that overlap along y one has its low end in the other: that is the one above. Of equal ends
// the lower number counts as below.
class Overlaps {
 public:
  using Numbers = std::vector<std::uint32_t>;  // of boxes, ascending by their left ends
  using Take = std::function<bool(std::uint32_t, std::uint32_t)>;

  Overlaps(std::span<const Bounds> boxes, const Take& take) : boxes_(boxes), take_(take) {}

  // Pairs of one of `below` and one of `above`, where that has its low end in the other.
  void find(const Numbers& below, const Numbers& above) {
    if (below.empty() || above.empty() || stopped_) return;
    std::vector<double> ends;
    for (const std::uint32_t i : above) ends.push_back(low(i));
    const auto middle = ends.begin() + static_cast<std::ptrdiff_t>(ends.size() / 2);
    std::nth_element(ends.begin(), middle, ends.end());
    const double least = *std::min_element(ends.begin(), middle + 1);
    const double most = *std::max_element(middle, ends.end()), split = *middle;
    Numbers across, others, first, second;
    for (const std::uint32_t i : below) {
      if (low(i) <= least && boxes_[i].high.y() >= most)
        across.push_back(i);
      else if (low(i) <= most && boxes_[i].high.y() >= least)
        others.push_back(i);
    }
    sweep(across, above);
    if (others.empty()) return;
    for (const std::uint32_t i : above)
      (low(i) < split || (least == split && low(i) == split) ? first : second).push_back(i);
    find(others, first);
    find(others, second);
  }

 private:
  double low(std::uint32_t i) const { return boxes_[i].low.y(); }

  // All of one overlap all of the other along y.
  void sweep(const Numbers& below, const Numbers& above) {
    const auto begins_first = [&](std::size_t i, std::size_t k) {
      return i < below.size() &&
             (k == above.size() || boxes_[below[i]].low.x() <= boxes_[above[k]].low.x());
    };
    for (std::size_t i = 0, k = 0; !stopped_ && (i < below.size() || k < above.size());) {
      const bool first = begins_first(i, k);
      const double end = boxes_[first ? below[i] : above[k]].high.x();
      const Numbers& later = first ? above : below;
      for (std::size_t n = first ? k : i;
           !stopped_ && n < later.size() && boxes_[later[n]].low.x() <= end; ++n)
        tell(first ? below[i] : later[n], first ? later[n] : above[k]);
      ++(first ? i : k);
    }
  }

  void tell(std::uint32_t below, std::uint32_t above) {
    if (low(below) > low(above) || (low(below) == low(above) && below >= above)) return;
    const auto [a, b] = std::minmax(below, above);
    stopped_ = !take_(a, b);
  }

  const std::span<const Bounds> boxes_;
  const Take& take_;
  bool stopped_ = false;
};

}  // namespace

void each_overlap(std::span<const Bounds> boxes, const std::vector<bool>& left_out,
                  const std::function<bool(std::uint32_t, std::uint32_t)>& take) {
  Overlaps::Numbers all, asked, others;
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    if (!boxes[i].empty()) all.push_back(i);
  std::sort(all.begin(), all.end(),
            [&](std::uint32_t i, std::uint32_t k) { return boxes[i].low.x() < boxes[k].low.x(); });
  for (const std::uint32_t i : all) (left_out[i] ? others : asked).push_back(i);
  Overlaps overlaps(boxes, take);
  overlaps.find(asked, all);
  overlaps.find(others, asked);
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> overlapping_pairs(
    std::span<const Bounds> boxes) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  each_overlap(boxes, std::vector<bool>(boxes.size(), false),
               [&](std::uint32_t a, std::uint32_t b) {
                 pairs.emplace_back(a, b);
                 return true;
               });
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
  across_ = static_cast<std::size_t>(across);
  first_.assign(across_ * across_, kNone);
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
