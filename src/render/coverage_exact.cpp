#include "render/coverage_exact.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geom/bounded.h"
#include "render/coverage_cell.h"
#include "render/coverage_chord.h"

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

bool is_exactly(const Rational& a, double b) { return a == Rational(b); }
bool is_exactly(const Bounded& a, double b) { return a.error() == 0 && a.lo() == 0 && a.hi() == b; }

bool same_edge(const ScanEdge& a, const ScanEdge& b) {
  return a.x_top == b.x_top && a.y_top == b.y_top && a.x_bottom == b.x_bottom &&
         a.y_bottom == b.y_bottom;
}
// They meet there and nowhere else, or lie on one line.
bool share_end(const ScanEdge& a, const ScanEdge& b) {
  const auto at = [](const ScanEdge& e, double x, double y) {
    return (e.x_top == x && e.y_top == y) || (e.x_bottom == x && e.y_bottom == y);
  };
  return at(a, b.x_top, b.y_top) || at(a, b.x_bottom, b.y_bottom);
}

// A line inside the pixel, in its coordinates: x = x_top + (y - y_top) * slope.
template <class Number>
struct Line {
  Number x_top, y_top, slope, y_bottom;
  int direction;
  const ScanEdge* edge;
  Number x(const Number& y) const { return x_top + (y - y_top) * slope; }
};

template <class Number>
struct Jump {
  Number y;
  int change;  // of the winding along the left border, from y down
};

// A height at which a slab begins. What one edge gives for one border it always gives in the same
// digits.
template <class Number>
struct Cut {
  Number y;
  std::uint32_t edge;
};
bool same_digits(const Rational& a, const Rational& b) { return a == b; }
bool same_digits(const Bounded& a, const Bounded& b) {
  return a.hi() == b.hi() && a.lo() == b.lo();
}

// Number is Rational, or Bounded where nothing turns out to be in doubt.
template <class Number>
class ExactPixel {
 public:
  ExactPixel(int winding, int column, int row, FillRule rule)
      : winding_(winding), column_(column), row_(row), rule_(rule) {}

  bool doubtful() const { return judge_.doubtful; }

  /// Needs   `e` to stay.
  void add(const ScanEdge& e) {
    const auto known = std::find_if(edges_.begin(), edges_.end(),
                                    [&](const ScanEdge* other) { return same_edge(*other, e); });
    edge_ = 1 + static_cast<std::uint32_t>(known - edges_.begin());
    if (known == edges_.end()) edges_.push_back(&e);
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
    bool full = true, empty = true;
    for (std::size_t i = 0; i + 1 < cuts.size() && !judge_.doubtful; ++i) {
      const Number width = covered((cuts[i] + cuts[i + 1]) * Number(0.5));
      full = full && is_exactly(width, 1);
      empty = empty && is_exactly(width, 0);
      sum = sum + (cuts[i + 1] - cuts[i]) * width;
    }
    if (full || empty) return Number(full ? 1 : 0);  // which the sum would put in doubt
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
    cuts_.push_back({y, edge_});
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
    if (!judge_.less(top, bottom)) return;
    lines_.push_back({x + (top - y) * slope, top, slope, bottom, e.direction, &e});
    cuts_.push_back({top, edge_});
    cuts_.push_back({bottom, edge_});
  }

  std::vector<Number> all_cuts() {
    std::vector<Cut<Number>> all = cuts_;
    for (std::size_t i = 0; i < lines_.size(); ++i)
      for (std::size_t k = i + 1; k < lines_.size(); ++k)
        if (std::optional<Number> y = crossing(lines_[i], lines_[k]))
          all.push_back({std::move(*y), kNoEdge});
    std::sort(all.begin(), all.end(),
              [](const auto& a, const auto& b) { return sorts_before(a.y, b.y); });
    std::vector<Number> cuts;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (i == 0 || is_below(all[i - 1], all[i])) cuts.push_back(all[i].y);
    return cuts;
  }

  bool is_below(const Cut<Number>& a, const Cut<Number>& b) {
    if (a.edge == b.edge && a.edge != kNoEdge && same_digits(a.y, b.y)) return false;
    return judge_.less(a.y, b.y);
  }

  std::optional<Number> crossing(const Line<Number>& a, const Line<Number>& b) {
    if (share_end(*a.edge, *b.edge)) return std::nullopt;
    const Number& top = judge_.max(a.y_top, b.y_top);
    const Number& bottom = judge_.min(a.y_bottom, b.y_bottom);
    if (!judge_.less(top, bottom)) return std::nullopt;
    const Number turn = a.slope - b.slope;
    if (judge_.sign(turn) == Sign::zero) return std::nullopt;
    const Number apart = b.x(top) - a.x(top);
    if (judge_.sign(apart) == Sign::zero) return std::nullopt;
    Number y = top + apart / turn;
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
    bool inside = covers(rule_, winding);
    for (const auto& [x, direction] : strands) {
      winding += direction;
      if (covers(rule_, winding) == inside) continue;
      if (inside) width = width + (x - from);
      inside = !inside;
      from = x;
    }
    if (inside) width = width + (Number(1) - from);
    return width;
  }

  int winding_;
  const int column_, row_;
  const FillRule rule_;
  Judge judge_;
  std::vector<Line<Number>> lines_;
  std::vector<Jump<Number>> jumps_;
  static constexpr std::uint32_t kNoEdge = 0;
  std::uint32_t edge_ = kNoEdge;  // the one being added, from 1; equal edges have one number
  std::vector<const ScanEdge*> edges_;
  std::vector<Cut<Number>> cuts_{{Number(0), kNoEdge}, {Number(1), kNoEdge}};
};

}  // namespace

Rational exact_area(std::span<const ScanEdge> edges, int winding, int column, int row,
                    FillRule rule) {
  ExactPixel<Rational> pixel(winding, column, row, rule);
  for (const ScanEdge& edge : edges) pixel.add(edge);
  return pixel.area();
}

std::uint32_t exact_steps(std::span<const ScanEdge> edges, int winding, int column, int row,
                          FillRule rule) {
  if (edges.size() == 1)
    if (const auto steps = chord_steps(edges[0], winding, column, row, rule)) return *steps;
  ExactPixel<Bounded> pixel(winding, column, row, rule);
  for (const ScanEdge& edge : edges) pixel.add(edge);
  if (!pixel.doubtful()) {
    const Bounded area = pixel.area();
    if (const auto steps = bounded_steps(area, 1); steps && !pixel.doubtful()) return *steps;
  }
  Rational steps = exact_area(edges, winding, column, row, rule) * Rational(kFullCoverage);
  return static_cast<std::uint32_t>(steps.floor().nearest());
}

}  // namespace flatray
