#include "render/coverage_exact.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geom/bounded.h"
#include "render/coverage_cell.h"

namespace flatray {
namespace {

// The comparisons of ExactPixel. Those of Bounded may be in doubt: then `doubtful` is set and the
// answer is any.
struct Judge {
  bool doubtful = false;

  Sign sign(const Rational& x) const { return x.sign(); }
  Sign sign(const Bounded& x) {
    const std::optional<Sign> known = x.sign();
    doubtful = doubtful || !known;
    return known.value_or(Sign::zero);
  }
  template <class Number>
  bool less(const Number& a, const Number& b) {
    return sign(a - b) == Sign::negative;
  }
  template <class Number>
  const Number& min(const Number& a, const Number& b) {
    return less(b, a) ? b : a;
  }
  template <class Number>
  const Number& max(const Number& a, const Number& b) {
    return less(a, b) ? b : a;
  }
};

// An order for sorting that is one whatever is in doubt; neighbours are judged afterwards.
bool sorts_before(const Rational& a, const Rational& b) { return a < b; }
bool sorts_before(const Bounded& a, const Bounded& b) {
  return a.hi() < b.hi() || (a.hi() == b.hi() && a.lo() < b.lo());
}

// A line inside the pixel, in its coordinates: x = x_top + (y - y_top) * slope.
template <class Number>
struct Line {
  Number x_top, y_top, slope, y_bottom;
  int direction;
  Number x(const Number& y) const { return x_top + (y - y_top) * slope; }
};

template <class Number>
struct Jump {
  Number y;
  int change;  // of the winding along the left border, from y down
};

// Number is Rational, or Bounded where nothing turns out to be in doubt.
template <class Number>
class ExactPixel {
 public:
  ExactPixel(int winding, int column, int row, FillRule rule)
      : winding_(winding), column_(column), row_(row), rule_(rule) {}

  bool doubtful() const { return judge_.doubtful; }

  void add(const ScanEdge& e) {
    const Number x = Number(e.x_top) - column_, y = Number(e.y_top) - row_;
    const Number dx = Number(e.x_bottom) - Number(e.x_top);
    const Number dy = Number(e.y_bottom) - Number(e.y_top);
    const Sign across = sign_of(e.x_bottom - e.x_top), down = sign_of(e.y_bottom - e.y_top);
    if (down != Sign::zero) count_top(e, x - y * (dx / dy), across);
    if (across != Sign::zero) cross_left(e, y - x * (dy / dx), across);
    if (down != Sign::zero) clip(e, x, y, dx, dy);
  }

  Number area() {
    const std::vector<Number> cuts = all_cuts();
    Number sum(0);
    for (std::size_t i = 0; i + 1 < cuts.size() && !judge_.doubtful; ++i)
      sum = sum + (cuts[i + 1] - cuts[i]) * covered((cuts[i] + cuts[i + 1]) * Number(0.5));
    return sum;
  }

 private:
  // The edge passes left of the corner at the row's upper border, or through the corner and on to
  // the left.
  void count_top(const ScanEdge& e, const Number& x, Sign dx) {
    if (!(e.y_top <= row_ && row_ < e.y_bottom)) return;
    const Sign side = judge_.sign(x);
    if (side == Sign::negative || (side == Sign::zero && dx == Sign::negative))
      winding_ += e.direction;
  }

  // The edge crosses the left border, which belongs to the pixel, strictly inside the row.
  void cross_left(const ScanEdge& e, const Number& y, Sign dx) {
    const auto [low, high] = std::minmax(e.x_top, e.x_bottom);
    if (!(low < column_ && column_ <= high)) return;
    if (judge_.sign(y) != Sign::positive || !judge_.less(y, Number(1))) return;
    jumps_.push_back({y, dx == Sign::positive ? -e.direction : e.direction});
  }

  void clip(const ScanEdge& e, const Number& x, const Number& y, const Number& dx,
            const Number& dy) {
    Number top = judge_.max(y, Number(0));
    Number bottom = judge_.min(Number(e.y_bottom) - row_, Number(1));
    const Number slope = dx / dy;
    if (e.x_top == e.x_bottom) {
      if (e.x_top < column_ || e.x_top > column_ + 1.0) return;
    } else {
      const Number at_left = y - x * (dy / dx), at_right = y + (Number(1) - x) * (dy / dx);
      const bool rightward = e.x_top < e.x_bottom;
      top = judge_.max(top, rightward ? at_left : at_right);
      bottom = judge_.min(bottom, rightward ? at_right : at_left);
    }
    if (judge_.less(top, bottom))
      lines_.push_back({x + (top - y) * slope, top, slope, bottom, e.direction});
  }

  std::vector<Number> all_cuts() {
    std::vector<Number> all{0, 1};
    for (const Jump<Number>& jump : jumps_) all.push_back(jump.y);
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      all.push_back(lines_[i].y_top);
      all.push_back(lines_[i].y_bottom);
      for (std::size_t k = i + 1; k < lines_.size(); ++k) {
        std::optional<Number> y = crossing(lines_[i], lines_[k]);
        if (y) all.push_back(std::move(*y));
      }
    }
    std::sort(all.begin(), all.end(),
              [](const Number& a, const Number& b) { return sorts_before(a, b); });
    std::vector<Number> cuts;
    for (Number& cut : all)
      if (cuts.empty() || judge_.less(cuts.back(), cut)) cuts.push_back(std::move(cut));
    return cuts;
  }

  std::optional<Number> crossing(const Line<Number>& a, const Line<Number>& b) {
    const Number& top = judge_.max(a.y_top, b.y_top);
    const Number& bottom = judge_.min(a.y_bottom, b.y_bottom);
    if (!judge_.less(top, bottom)) return std::nullopt;
    const Number turn = a.slope - b.slope;
    if (judge_.sign(turn) == Sign::zero) return std::nullopt;
    Number y = top + (b.x(top) - a.x(top)) / turn;
    if (!judge_.less(top, y) || !judge_.less(y, bottom)) return std::nullopt;
    return y;
  }

  // Width covered at height y, which is no cut.
  Number covered(const Number& y) {
    int winding = winding_;
    for (const Jump<Number>& jump : jumps_)
      if (judge_.less(jump.y, y)) winding += jump.change;
    std::vector<std::pair<Number, int>> strands;
    for (const Line<Number>& line : lines_)
      if (judge_.less(line.y_top, y) && judge_.less(y, line.y_bottom))
        strands.emplace_back(line.x(y), line.direction);
    // Where two have one x there, the width between them is 0 or in the error: any order will do.
    std::sort(strands.begin(), strands.end(),
              [](const auto& a, const auto& b) { return sorts_before(a.first, b.first); });
    Number width(0), from(0);
    for (const auto& [x, direction] : strands) {
      if (covers(rule_, winding)) width = width + (x - from);
      winding += direction;
      from = x;
    }
    if (covers(rule_, winding)) width = width + (Number(1) - from);
    return width;
  }

  int winding_;
  const int column_, row_;
  const FillRule rule_;
  Judge judge_;
  std::vector<Line<Number>> lines_;
  std::vector<Jump<Number>> jumps_;
};

// The step of an area, unless it is in doubt.
std::optional<std::uint32_t> bounded_steps(const Bounded& area) {
  const Bounded steps = area * Bounded(kFullCoverage);
  const double low = std::clamp(std::floor(steps.hi()), 0.0, double{kFullCoverage});
  for (const double step : {low, low - 1}) {  // hi may have been rounded up to a step
    if (step < 0 || (steps - Bounded(step)).sign().value_or(Sign::negative) == Sign::negative)
      continue;
    if ((steps - Bounded(step + 1)).sign() != Sign::negative) return std::nullopt;
    return static_cast<std::uint32_t>(step);
  }
  return std::nullopt;
}

}  // namespace

Rational exact_area(std::span<const ScanEdge> edges, int winding, int column, int row,
                    FillRule rule) {
  ExactPixel<Rational> pixel(winding, column, row, rule);
  for (const ScanEdge& edge : edges) pixel.add(edge);
  return pixel.area();
}

std::uint32_t exact_steps(std::span<const ScanEdge> edges, int winding, int column, int row,
                          FillRule rule) {
  ExactPixel<Bounded> pixel(winding, column, row, rule);
  for (const ScanEdge& edge : edges) pixel.add(edge);
  if (!pixel.doubtful()) {
    const Bounded area = pixel.area();
    if (const auto steps = bounded_steps(area); steps && !pixel.doubtful()) return *steps;
  }
  Rational steps = exact_area(edges, winding, column, row, rule) * Rational(kFullCoverage);
  return static_cast<std::uint32_t>(steps.floor().nearest());
}

}  // namespace flatray
