#include <algorithm>
#include <cmath>

#include "render/coverage_cell.h"

namespace flatray {
namespace {

constexpr double kUlpOfOne = 0x1p-52;

double x_of(const Piece& p, double y) {
  if (y <= p.y_top) return p.x_top;
  if (y >= p.y_bottom) return p.x_bottom;
  const double x = p.x_top + (y - p.y_top) * ((p.x_bottom - p.x_top) / (p.y_bottom - p.y_top));
  return std::clamp(x, std::min(p.x_top, p.x_bottom), std::max(p.x_top, p.x_bottom));
}

double middle(const Strand& s) { return s.upper + s.lower; }

// The slabs of one pixel. Besides the area it keeps the lowest and highest winding any point of the
// pixel may have, whatever the errors do: strands closer than `near_` may stand in another order
// than computed, unless they part from a common vertex.
class Slabs {
 public:
  Slabs(std::span<const Piece> pieces, int winding, FillRule rule, SlabWork& work)
      : pieces_(pieces), winding_(winding), rule_(rule), work_(work) {}

  CellArea run() {
    measure_errors();
    collect_cuts();
    for (std::size_t i = 0; i + 1 < work_.cuts.size(); ++i) slab(work_.cuts[i], work_.cuts[i + 1]);
    CellArea result{std::min(area_, 1.0), 0, false};
    if (exact_) return result;
    // Each end may move by its error, each pair of strands be taken in the wrong order while they
    // are within three of them (docs/NUMERICS.md, coverage); each slab rounds its width and adds
    // it.
    const double n = static_cast<double>(pieces_.size());
    result.bound = n * (16 * error_ + 32 * kUlpOfOne) + static_cast<double>(slabs_) * 2 * kUlpOfOne;
    result.full = rule_ == FillRule::nonzero && (lowest_ > 0 || highest_ < 0) && jumps_apart();
    return result;
  }

 private:
  // What lies beyond a piece flatter than its error no slab may see: for the windings it counts as
  // a ghost. An edge through a corner of the pixel has such a piece.
  void measure_errors() {
    for (const Piece& p : pieces_) {
      error_ = std::max(error_, p.error);
      exact_ = exact_ && p.exact && !p.ghost;
    }
    near_ = 8 * error_ + 16 * kUlpOfOne;
    for (const Piece& p : pieces_)
      if (p.ghost || (p.error > 0 && p.y_bottom - p.y_top <= near_)) ++ghosts_;
  }

  void collect_cuts() {
    std::vector<double>& cuts = work_.cuts;
    cuts.assign({0.0, 1.0});
    for (const Piece& p : pieces_) {
      if (p.ghost) continue;
      cuts.push_back(p.y_top);
      cuts.push_back(p.y_bottom);
    }
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  }

  // Winding along the left border between two cuts.
  int left_winding(double upper) const {
    int winding = winding_;
    for (const Piece& p : pieces_) {
      if (p.left_top && p.y_top <= upper) winding -= p.direction;
      if (p.left_bottom && p.y_bottom <= upper) winding += p.direction;
    }
    return winding;
  }

  void slab(double upper, double lower) {
    std::vector<Strand>& strands = work_.strands;
    strands.clear();
    for (const Piece& p : pieces_)
      if (!p.ghost && p.y_top <= upper && p.y_bottom >= lower)
        strands.push_back({&p, x_of(p, upper), x_of(p, lower)});
    const int left = left_winding(upper);
    sort_strands();
    if (in_order()) return add(upper, lower, left);
    exact_ = false;
    split(upper, lower, left);
  }

  void sort_strands() {
    std::sort(work_.strands.begin(), work_.strands.end(),
              [](const Strand& a, const Strand& b) { return middle(a) < middle(b); });
  }

  bool in_order() const {
    for (std::size_t i = 1; i < work_.strands.size(); ++i) {
      const Strand &a = work_.strands[i - 1], &b = work_.strands[i];
      if (a.upper > b.upper || a.lower > b.lower) return false;
    }
    return true;
  }

  // Cuts a slab at the crossings of its strands.
  void split(double upper, double lower, int left) {
    std::vector<double>& crossings = work_.crossings;
    crossings.assign({upper, lower});
    const std::vector<Strand>& strands = work_.strands;
    for (std::size_t i = 0; i < strands.size(); ++i)
      for (std::size_t k = i + 1; k < strands.size(); ++k) {
        const double above = strands[i].upper - strands[k].upper;
        const double below = strands[i].lower - strands[k].lower;
        if ((above < 0) == (below < 0) || above == 0 || below == 0) continue;
        const double share = std::abs(above) / (std::abs(above) + std::abs(below));
        crossings.push_back(std::clamp(upper + (lower - upper) * share, upper, lower));
      }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
      if (crossings[i] == crossings[i + 1]) continue;
      for (Strand& s : work_.strands) {
        s.upper = x_of(*s.piece, crossings[i]);
        s.lower = x_of(*s.piece, crossings[i + 1]);
      }
      sort_strands();
      add(crossings[i], crossings[i + 1], left);
    }
  }

  void add(double upper, double lower, int left) {
    double covered = 0, from = 0;
    int winding = left;
    for (const Strand& s : work_.strands) {
      const double x = 0.5 * middle(s);
      if (covers(rule_, winding)) covered += x - from;
      winding += s.piece->direction;
      from = x;
    }
    if (covers(rule_, winding)) covered += 1 - from;
    area_ += (lower - upper) * covered;
    ++slabs_;
    bound_winding(upper, lower, left);
  }

  // Strands in groups that may stand in any order.
  void bound_winding(double upper, double lower, int left) {
    int before = left, fall = 0, rise = 0;
    const auto close = [&] {
      lowest_ = std::min(lowest_, before + fall - ghosts_);
      highest_ = std::max(highest_, before + rise + ghosts_);
      before += fall + rise;
      fall = rise = 0;
    };
    const Strand* last = nullptr;
    for (const Strand& s : work_.strands) {
      if (last != nullptr && apart(*last, s, upper, lower)) close();
      (s.piece->direction < 0 ? fall : rise) += s.piece->direction;
      last = &s;
    }
    close();
    lowest_ = std::min(lowest_, before - ghosts_);
    highest_ = std::max(highest_, before + ghosts_);
  }

  bool apart(const Strand& a, const Strand& b, double upper, double lower) const {
    const Piece &p = *a.piece, &q = *b.piece;
    const bool above = b.upper - a.upper > near_, below = b.lower - a.lower > near_;
    const bool part =
        p.vertex_top && q.vertex_top && p.y_top == upper && q.y_top == upper && p.x_top == q.x_top;
    const bool join = p.vertex_bottom && q.vertex_bottom && p.y_bottom == lower &&
                      q.y_bottom == lower && p.x_bottom == q.x_bottom;
    return (above && below) || (part && below) || (above && join);
  }

  // No two crossings of the left border, one up and one down, may be in the wrong order.
  bool jumps_apart() const {
    for (const Piece& p : pieces_)
      for (const Piece& q : pieces_)
        if (jump(p) * jump(q) < 0 && std::abs(jump_y(p) - jump_y(q)) <= near_) return false;
    return true;
  }
  static int jump(const Piece& p) {
    return p.left_top ? -p.direction : p.left_bottom ? p.direction : 0;
  }
  static double jump_y(const Piece& p) { return p.left_top ? p.y_top : p.y_bottom; }

  std::span<const Piece> pieces_;
  const int winding_;
  const FillRule rule_;
  SlabWork& work_;
  double area_ = 0, error_ = 0, near_ = 0;
  std::size_t slabs_ = 0;
  int ghosts_ = 0, lowest_ = 1 << 30, highest_ = -(1 << 30);
  bool exact_ = true;
};

}  // namespace

CellArea slab_area(std::span<const Piece> pieces, int winding, FillRule rule, SlabWork& work) {
  return Slabs(pieces, winding, rule, work).run();
}

}  // namespace flatray
