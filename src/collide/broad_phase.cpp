#include "collide/broad_phase.h"

#include <algorithm>

namespace flatray {
namespace {

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
  std::ranges::sort(all, {}, [&](std::uint32_t i) { return boxes[i].low.x(); });
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
  std::ranges::sort(pairs);
  return pairs;
}

Bounds swept(const Bounds& box, const Vec2& velocity, double length) {
  if (box.empty()) return box;
  Bounds all = box;
  const Vec2 way = velocity * length;
  all.add(Bounds{box.low + way, box.high + way});
  // A product and a sum, each off by half an ulp of what goes in, or of the least double.
  constexpr double kUlps = 0x1p-51, kLeast = 0x1p-1060;
  const Vec2 sizes = all.low.cwiseAbs().cwiseMax(all.high.cwiseAbs()) + way.cwiseAbs();
  const Vec2 room = kUlps * sizes + Vec2::Constant(kLeast);
  all.low -= room;
  all.high += room;
  return all;
}

}  // namespace flatray
