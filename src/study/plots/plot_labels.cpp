#include "study/plots/plot_labels.h"

#include <algorithm>
#include <array>

#include "geom/bounds.h"

namespace flatray {
namespace {

constexpr double kHalfHeight = 7, kGapBeside = 2,
                 kMarkRoom = 4;  // of words, beside them, of what else is kept free
constexpr std::array kAway = {9.0, 15.0, 24.0, 36.0, 50.0, 66.0, 84.0, 104.0, 126.0, 150.0};
constexpr double kNear = 15;  // up to which no line need lead to the words
// Right, left, above, below and between.
const std::array<Vec2, 8> kSides = {Vec2(1, 0),      Vec2(-1, 0),     Vec2(0, -1),
                                    Vec2(0, 1),      Vec2(0.7, -0.7), Vec2(-0.7, -0.7),
                                    Vec2(-0.7, 0.7), Vec2(0.7, 0.7)};

bool overlap(const Bounds& a, const Bounds& b) {
  return a.low.x() < b.high.x() && b.low.x() < a.high.x() && a.low.y() < b.high.y() &&
         b.low.y() < a.high.y();
}

// Boxes within a frame, sorted into cells, so that a box is asked only against those near it.
class TakenBoxes {
 public:
  TakenBoxes(const Vec2& low, const Vec2& high) : low_(low) {
    columns_ = cell(high).x() + 1;
    rows_ = cell(high).y() + 1;
    cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  }
  void add(const Bounds& box) {
    visit(box, [&](std::vector<Bounds>& boxes) {
      boxes.push_back(box);
      return false;
    });
  }
  bool overlaps(const Bounds& box) {
    return visit(box, [&](const std::vector<Bounds>& boxes) {
      return std::ranges::any_of(boxes, [&](const Bounds& one) { return overlap(one, box); });
    });
  }

 private:
  static constexpr double kCell = 32;
  Eigen::Vector2i cell(const Vec2& point) const {
    const Vec2 place = (point - low_) / kCell;
    return place.array().floor().max(-1.0).min(1e4).matrix().cast<int>();
  }
  // Until one of the cells that a box lies in says so; whether one did.
  template <class Visitor>
  bool visit(const Bounds& box, const Visitor& visitor) {
    const Eigen::Vector2i from = cell(box.low), to = cell(box.high);
    for (int row = std::max(from.y(), 0); row <= std::min(to.y(), rows_ - 1); ++row)
      for (int column = std::max(from.x(), 0); column <= std::min(to.x(), columns_ - 1); ++column)
        if (visitor(cells_[static_cast<std::size_t>(row * columns_ + column)])) return true;
    return false;
  }

  Vec2 low_;
  int columns_, rows_;
  std::vector<std::vector<Bounds>> cells_;
};

// Which part of words that stand on that side is left of where they begin.
double anchor(const Vec2& side) { return side.x() > 0 ? 0 : side.x() < 0 ? 1 : 0.5; }

}  // namespace

void PointLabels::draw(Drawing& onto) const {
  TakenBoxes taken(low_, high_);
  for (const Vec2& point : points_)
    taken.add({point - Vec2(kMarkRoom, kMarkRoom), point + Vec2(kMarkRoom, kMarkRoom)});
  for (const Label& label : labels_)
    [&] {
      for (const double away : kAway)
        for (const Vec2& side : kSides) {
          const double width = words_width(label.words);
          const Vec2 at = label.at + away * side;
          const Vec2 low = at - Vec2(anchor(side) * width + kGapBeside, kHalfHeight);
          const Bounds box{low, low + Vec2(width + 2 * kGapBeside, 2 * kHalfHeight)};
          if (box.low.x() < low_.x() || box.high.x() > high_.x() || box.low.y() < low_.y() ||
              box.high.y() > high_.y() || taken.overlaps(box))
            continue;
          taken.add(box);
          if (away > kNear)
            onto.marks.push_back(
                Drawing::Path{{label.at + 4 * side, at - 2 * side}, {"axis", "", 0.7}});
          onto.marks.push_back(Drawing::Words{at, label.words, anchor(side)});
          return;
        }
    }();
}

}  // namespace flatray
