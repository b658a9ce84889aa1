#include "render/coverage_exact.h"

#include <algorithm>
#include <optional>

#include "render/coverage_cell.h"

namespace flatray {
namespace {

// A line inside the pixel, in its coordinates: x = x_top + (y - y_top) * slope.
struct Line {
  Rational x_top, y_top, slope, y_bottom;
  int direction;
  Rational x(const Rational& y) const { return x_top + (y - y_top) * slope; }
};

struct Jump {
  Rational y;
  int change;  // of the winding along the left border, from y down
};

class ExactPixel {
 public:
  ExactPixel(int winding, int column, int row, FillRule rule)
      : winding_(winding), column_(column), row_(row), rule_(rule) {}

  void add(const ScanEdge& e) {
    const Rational x = Rational(e.x_top) - column_, y = Rational(e.y_top) - row_;
    const Rational dx = Rational(e.x_bottom) - Rational(e.x_top);
    const Rational dy = Rational(e.y_bottom) - Rational(e.y_top);
    if (dy.sign() != Sign::zero) count_top(e, x - y * (dx / dy), dx.sign());
    if (dx.sign() != Sign::zero) cross_left(e, y - x * (dy / dx), dx.sign());
    if (dy.sign() != Sign::zero) clip(e, x, y, dx, dy);
  }

  Rational area() {
    std::vector<Rational> cuts = all_cuts();
    Rational sum;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
      sum += (cuts[i + 1] - cuts[i]) * covered((cuts[i] + cuts[i + 1]) * Rational(0.5));
    return sum;
  }

 private:
  // The edge passes left of the corner at the row's upper border, or through the corner and on to
  // the left.
  void count_top(const ScanEdge& e, const Rational& x, Sign dx) {
    if (!(e.y_top <= row_ && row_ < e.y_bottom)) return;
    const Sign side = x.sign();
    if (side == Sign::negative || (side == Sign::zero && dx == Sign::negative))
      winding_ += e.direction;
  }

  // The edge crosses the left border, which belongs to the pixel, strictly inside the row.
  void cross_left(const ScanEdge& e, const Rational& y, Sign dx) {
    const auto [low, high] = std::minmax(e.x_top, e.x_bottom);
    if (!(low < column_ && column_ <= high) || !(y > 0) || !(y < 1)) return;
    jumps_.push_back({y, dx == Sign::positive ? -e.direction : e.direction});
  }

  void clip(const ScanEdge& e, const Rational& x, const Rational& y, const Rational& dx,
            const Rational& dy) {
    Rational top = std::max(y, Rational(0));
    Rational bottom = std::min(Rational(e.y_bottom) - row_, Rational(1));
    const Rational slope = dx / dy;
    if (dx.sign() == Sign::zero) {
      if (x < 0 || x > 1) return;
    } else {
      const Rational at_left = y - x / slope, at_right = y + (Rational(1) - x) / slope;
      top = std::max(top, std::min(at_left, at_right));
      bottom = std::min(bottom, std::max(at_left, at_right));
    }
    if (top < bottom) lines_.push_back({x + (top - y) * slope, top, slope, bottom, e.direction});
  }

  std::vector<Rational> all_cuts() const {
    std::vector<Rational> cuts{0, 1};
    for (const Jump& jump : jumps_) cuts.push_back(jump.y);
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      cuts.push_back(lines_[i].y_top);
      cuts.push_back(lines_[i].y_bottom);
      for (std::size_t k = i + 1; k < lines_.size(); ++k) {
        std::optional<Rational> y = crossing(lines_[i], lines_[k]);
        if (y) cuts.push_back(std::move(*y));
      }
    }
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    return cuts;
  }

  static std::optional<Rational> crossing(const Line& a, const Line& b) {
    const Rational& top = std::max(a.y_top, b.y_top);
    const Rational& bottom = std::min(a.y_bottom, b.y_bottom);
    if (top >= bottom || a.slope == b.slope) return std::nullopt;
    Rational y = top + (b.x(top) - a.x(top)) / (a.slope - b.slope);
    if (y <= top || y >= bottom) return std::nullopt;
    return y;
  }

  // Width covered at height y, which is no cut.
  Rational covered(const Rational& y) const {
    int winding = winding_;
    for (const Jump& jump : jumps_)
      if (jump.y < y) winding += jump.change;
    std::vector<std::pair<Rational, int>> strands;
    for (const Line& line : lines_)
      if (line.y_top < y && y < line.y_bottom) strands.emplace_back(line.x(y), line.direction);
    std::sort(strands.begin(), strands.end());
    Rational width, from;
    for (const auto& [x, direction] : strands) {
      if (covers(rule_, winding)) width += x - from;
      winding += direction;
      from = x;
    }
    if (covers(rule_, winding)) width += Rational(1) - from;
    return width;
  }

  int winding_;
  const int column_, row_;
  const FillRule rule_;
  std::vector<Line> lines_;
  std::vector<Jump> jumps_;
};

}  // namespace

Rational exact_area(std::span<const ScanEdge> edges, int winding, int column, int row,
                    FillRule rule) {
  ExactPixel pixel(winding, column, row, rule);
  for (const ScanEdge& edge : edges) pixel.add(edge);
  return pixel.area();
}

}  // namespace flatray
