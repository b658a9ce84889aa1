#include "study/plots/plot_labels.h"

#include <algorithm>
#include <array>

#include "geom/bounds.h"

namespace flatray {
namespace {

constexpr double kHalfHeight = 7, kGap = 2,
                 kMark = 4;  // of words, beside them, of what else is kept free
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

// Which part of words that stand on that side is left of where they begin.
double anchor(const Vec2& side) { return side.x() > 0 ? 0 : side.x() < 0 ? 1 : 0.5; }

}  // namespace

void PointLabels::draw(Drawing& onto) const {
  std::vector<Bounds> taken;
  for (const Vec2& point : points_)
    taken.push_back({point - Vec2(kMark, kMark), point + Vec2(kMark, kMark)});
  for (const Label& label : labels_)
    [&] {
      for (const double away : kAway)
        for (const Vec2& side : kSides) {
          const double width = words_width(label.words);
          const Vec2 at = label.at + away * side;
          const Vec2 low = at - Vec2(anchor(side) * width + kGap, kHalfHeight);
          const Bounds box{low, low + Vec2(width + 2 * kGap, 2 * kHalfHeight)};
          if (box.low.x() < low_.x() || box.high.x() > high_.x() || box.low.y() < low_.y() ||
              box.high.y() > high_.y() ||
              std::any_of(taken.begin(), taken.end(),
                          [&](const Bounds& one) { return overlap(one, box); }))
            continue;
          taken.push_back(box);
          if (away > kNear)
            onto.marks.push_back(
                Drawing::Path{{label.at + 4 * side, at - 2 * side}, {"axis", "", 0.7}});
          onto.marks.push_back(Drawing::Words{at, label.words, anchor(side)});
          return;
        }
    }();
}

}  // namespace flatray
