#include "study/plots/line_density.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/portable_math.h"
#include "geom/clip.h"
#include "study/plots/palette.h"

namespace flatray {

LineDensity::LineDensity(const Bounds& window, int width, int height)
    : window_(window),
      width_(width),
      height_(height),
      cells_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

// From one line of the grid to the next, in whichever direction comes first.
void LineDensity::add(const Vec2& from, const Vec2& to) {
  const Vec2 scale(width_ / window_.size().x(), height_ / window_.size().y());
  const auto cell = [&](const Vec2& p) {
    return Vec2((p.x() - window_.low.x()) * scale.x(), (window_.high.y() - p.y()) * scale.y());
  };
  const Vec2 a = cell(from), b = cell(to), d = b - a;
  const std::array<Vec2, 4> film = {Vec2(0, 0), Vec2(width_, 0), Vec2(width_, height_),
                                    Vec2(0, height_)};
  const HitInterval part = clip_convex({a, d}, film, kSegment);
  if (!part || !(part.t_enter < part.t_exit)) return;
  const double length = std::sqrt(d.x() * d.x() + d.y() * d.y());
  for (double t = part.t_enter; t < part.t_exit;) {
    double next = part.t_exit;
    for (int axis = 0; axis < 2; ++axis) {
      const double x = a[axis] + t * d[axis];
      const double line = d[axis] > 0 ? std::floor(x) + 1 : std::ceil(x) - 1;
      if (d[axis] != 0) next = std::min(next, (line - a[axis]) / d[axis]);
    }
    next = std::max(next, std::nextafter(t, kInfinity));
    const Vec2 middle = a + 0.5 * (t + next) * d;
    const int x = std::clamp(static_cast<int>(std::floor(middle.x())), 0, width_ - 1),
              y = std::clamp(static_cast<int>(std::floor(middle.y())), 0, height_ - 1);
    cells_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x)] += (next - t) * length;
    t = next;
  }
}

void LineDensity::add_cells(std::span<const double> cells) {
  for (std::size_t i = 0; i < cells_.size(); ++i) cells_[i] += cells[i];
}

double LineDensity::scale() const {
  const double sum = std::accumulate(cells_.begin(), cells_.end(), 0.0);
  const auto lit = std::ranges::count_if(cells_, [](double cell) { return cell > 0; });
  return sum > 0 ? 0.7 * static_cast<double>(lit) / sum : 0;
}

Image LineDensity::picture() const {
  const double by = scale();
  return image_of(width_, height_,
                  [&](std::size_t i) { return heat(1 - portable::exp(-by * cells_[i])); });
}

}  // namespace flatray
