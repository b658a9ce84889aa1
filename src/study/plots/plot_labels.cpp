#include "study/plots/plot_labels.h"

#include <array>

#include "collide/box_grid.h"

namespace flatray {
namespace {

constexpr double kHalfHeight = 7, kGapBeside = 2,
                 kMarkRoom = 4;  // of words, beside them, of what else is kept free
constexpr std::array kAway = {9.0, 15.0, 24.0, 36.0, 50.0, 66.0, 84.0, 104.0, 126.0, 150.0};
constexpr double kNear = 15;             // up to which no line need lead to the words
constexpr std::size_t kMostTried = 300;  // of words for which there is no place
// Right, left, above, below and between.
const std::array<Vec2, 8> kSides = {Vec2(1, 0),      Vec2(-1, 0),     Vec2(0, -1),
                                    Vec2(0, 1),      Vec2(0.7, -0.7), Vec2(-0.7, -0.7),
                                    Vec2(-0.7, 0.7), Vec2(0.7, 0.7)};

// Whether more than their borders have a point in common.
bool overlap(const Bounds& a, const Bounds& b) {
  return a.low.x() < b.high.x() && b.low.x() < a.high.x() && a.low.y() < b.high.y() &&
         b.low.y() < a.high.y();
}

// Which part of words that stand on that side is left of where they begin.
double anchor(const Vec2& side) { return side.x() > 0 ? 0 : side.x() < 0 ? 1 : 0.5; }

}  // namespace

std::size_t PointLabels::draw(Drawing& onto) const {
  const Vec2 room(kMarkRoom, kMarkRoom);
  std::vector<Bounds> boxes;
  for (const Vec2& point : points_) boxes.push_back({point - room, point + room});
  auto number = static_cast<std::uint32_t>(boxes.size());
  boxes.resize(boxes.size() + labels_.size());  // those of words are empty until they have a place
  BoxGrid taken(std::move(boxes));
  const auto is_free = [&](const Bounds& box) {
    const Bounds frame{low_, high_};
    bool free = frame.contains(box.low) && frame.contains(box.high);
    if (!free) return false;
    taken.each_near(box, [&](std::uint32_t k) { free = free && !overlap(box, taken.boxes()[k]); });
    return free;
  };
  const auto place = [&](const Label& label) {
    for (const double away : kAway)
      for (const Vec2& side : kSides) {
        const double width = words_width(label.words);
        const Vec2 at = label.at + away * side;
        const Vec2 low = at - Vec2(anchor(side) * width + kGapBeside, kHalfHeight);
        const Bounds box{low, low + Vec2(width + 2 * kGapBeside, 2 * kHalfHeight)};
        if (!is_free(box)) continue;
        taken.change(number++, box);
        if (away > kNear)
          onto.marks.push_back(
              Drawing::Path{{label.at + 4 * side, at - 2 * side}, {"axis", "", 0.7}});
        onto.marks.push_back(Drawing::Words{at, label.words, anchor(side)});
        return true;
      }
    return false;
  };
  std::size_t left_out = 0;
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    if (left_out == kMostTried) return labels_.size() - i + left_out;
    if (!place(labels_[i])) ++left_out;
  }
  return 0;
}

}  // namespace flatray
