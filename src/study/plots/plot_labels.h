#pragma once
#include <string>
#include <vector>

#include "study/plots/drawing.h"

namespace flatray {

/// Words beside points, none over another and none over a point: to the right where there is room,
/// else round the point, farther out with a line that leads there. What finds no place within the
/// axes is left out.
class PointLabels {
 public:
  /// Upper left and lower right corner of where they may stand.
  PointLabels(const Vec2& low, const Vec2& high) : low_(low), high_(high) {}
  void keep_free(const Vec2& point) { points_.push_back(point); }
  void add(const Vec2& point, const std::string& words) { labels_.push_back({point, words}); }
  /// Gives   how many were left out where these are so many that no place was looked for in the end;
  ///         0 where each had its chance.
  std::size_t draw(Drawing& onto) const;

 private:
  struct Label {
    Vec2 at;
    std::string words;
  };
  Vec2 low_, high_;
  std::vector<Vec2> points_;
  std::vector<Label> labels_;
};

}  // namespace flatray
