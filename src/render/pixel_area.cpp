#include "render/pixel_area.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace flatray {
namespace {

double x_at(const PieceOf& of, double y, int row) {
  const Piece& p = *of.piece;
  if (y <= p.y_top) return p.x_top;
  if (y >= p.y_bottom) return p.x_bottom;
  if (p.curve == nullptr) return p.x_top + of.slope * (y - p.y_top);
  const Vec2& centre = p.curve->ellipse.centre;
  return clamp_between(centre.x() + p.curve->x.at(row + y - centre.y()) - p.column, p.x_top,
                       p.x_bottom);
}

// Mean of x between two heights.
double mean_x(const PieceOf& of, double top, double bottom, int row) {
  if (of.piece->curve == nullptr) return x_at(of, 0.5 * (top + bottom), row);
  const double upper = x_at(of, top, row), lower = x_at(of, bottom, row);
  return 0.5 * (upper + lower) - of.piece->curve->bow(lower - upper, bottom - top) / (bottom - top);
}

// Where two pieces cross one another, to some 2^-27: what is wrong beside a crossing is its square.
class Crossings {
 public:
  Crossings(const PieceOf& a, const PieceOf& b, int row, std::vector<double>& cuts)
      : a_(a), b_(b), row_(row), cuts_(cuts) {
    const double top = std::max(a.piece->y_top, b.piece->y_top);
    const double bottom = std::min(a.piece->y_bottom, b.piece->y_bottom);
    if (!(top < bottom)) return;
    const double first = gap(top), last = gap(bottom);
    if (a.piece->curve == nullptr && b.piece->curve == nullptr) {
      if (first * last < 0) cuts_.push_back(top + (bottom - top) * (first / (first - last)));
      return;
    }
    if (first * last < 0) {
      add(top, bottom, first < 0);
      return;
    }
    if (std::min(std::abs(first), std::abs(last)) > 0x1p-40 + a.bend + b.bend) return;
    const double side = first + last, middle = extreme(top, bottom, side);
    if (!(side * gap(middle) < 0)) return;
    add(top, middle, first < 0);
    add(middle, bottom, last > 0);
  }

 private:
  static constexpr int kSteps = 27;

  double gap(double y) const { return x_at(a_, y, row_) - x_at(b_, y, row_); }

  // Where the gap changes its sign.
  void add(double low, double high, bool rises) {
    for (int i = 0; i < kSteps; ++i) {
      const double middle = 0.5 * (low + high);
      ((gap(middle) < 0) == rises ? low : high) = middle;
    }
    cuts_.push_back(0.5 * (low + high));
  }

  // Where a gap that is of one sign at both ends comes nearest to the other, by thirds.
  double extreme(double low, double high, double side) const {
    for (int i = 0; i < kSteps; ++i) {
      const double third = (high - low) / 3, a = low + third, b = high - third;
      if (side * gap(a) < side * gap(b))
        high = b;
      else
        low = a;
    }
    return 0.5 * (low + high);
  }

  const PieceOf &a_, &b_;
  const int row_;
  std::vector<double>& cuts_;
};

// The winding number along the left border changes where an edge crosses it.
int left_change(const PieceOf& of, double from, double to) {
  const Piece& p = *of.piece;
  if (p.left_top && from <= p.y_top && p.y_top < to) return -of.direction;
  if (p.left_bottom && from <= p.y_bottom && p.y_bottom < to) return of.direction;
  return 0;
}

// Pieces that lie on one another become one of all their directions.
void join_equal(std::vector<PieceOf>& pieces) {
  const auto place = [](const PieceOf& of) {
    const Piece& p = *of.piece;
    return std::tuple(of.seen, p.x_top, p.y_top, p.x_bottom, p.y_bottom, p.curve, p.left_top,
                      p.left_bottom);
  };
  std::sort(pieces.begin(), pieces.end(),
            [&](const PieceOf& a, const PieceOf& b) { return place(a) < place(b); });
  auto last = pieces.begin();
  for (auto next = last + 1; next != pieces.end(); ++next) {
    if (place(*last) == place(*next))
      last->direction += next->direction;
    else
      *++last = *next;
  }
  pieces.erase(last + 1, pieces.end());
}

// Whether more pieces pass by one another than kCrowd do among themselves. Sorts them.
bool is_crowd(std::vector<PieceOf>& pieces) {
  if (pieces.size() <= kCrowd) return false;
  join_equal(pieces);
  std::sort(pieces.begin(), pieces.end(),
            [](const PieceOf& a, const PieceOf& b) { return a.piece->y_top < b.piece->y_top; });
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (std::size_t k = i + 1;
         k < pieces.size() && pieces[k].piece->y_top < pieces[i].piece->y_bottom; ++k)
      if (++pairs > kCrowd * kCrowd / 2) return true;
  return pieces.size() > kCrowd * kCrowd / 2;
}

double place_before(double x) { return std::floor(x * kPlaces) / kPlaces; }

}  // namespace

PieceOf::PieceOf(const Piece& of, std::uint32_t item)
    : piece(&of), seen(item), direction(of.direction) {
  const double width = of.x_bottom - of.x_top, height = of.y_bottom - of.y_top;
  if (height < 0x1p-900) return;  // without area, too
  slope = width / height;
  if (of.curve != nullptr) bend = 2 * std::abs(of.curve->bow(width, height)) / height;
}

double area_right_of(const Piece& p) {
  double area = (p.y_bottom - p.y_top) * (1 - 0.5 * (p.x_top + p.x_bottom));
  if (p.curve != nullptr) area += p.curve->bow(p.x_bottom - p.x_top, p.y_bottom - p.y_top);
  if (p.left_top) area -= 1 - p.y_top;
  if (p.left_bottom) area += 1 - p.y_bottom;
  return p.direction * area;
}

// Between which the light is summed.
void PixelArea::find_cuts(std::span<const PieceOf> pieces, int row) {
  cuts_ = {0, 1};
  if (crowded_) {
    const std::size_t strips = std::max(kStrips * kCrowd / pieces.size(), kLeastStrips);
    for (std::size_t i = 1; i < strips; ++i)
      cuts_.push_back(static_cast<double>(i) / static_cast<double>(strips));
  } else {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const Piece& piece = *pieces[i].piece;
      if (piece.y_top > 0) cuts_.push_back(piece.y_top);
      if (piece.y_bottom < 1) cuts_.push_back(piece.y_bottom);
      for (std::size_t k = 0; k < i; ++k) Crossings(pieces[i], pieces[k], row, cuts_);
    }
  }
  std::sort(cuts_.begin(), cuts_.end());
}

// The pieces that pass through a slab; in a crowd along its middle.
void PixelArea::find_strands(std::span<const PieceOf> pieces, double top, double bottom, int row) {
  const double middle = 0.5 * (top + bottom);
  strands_.clear();
  for (const PieceOf& of : pieces) {
    const bool spans = crowded_ ? of.piece->y_top <= middle && middle < of.piece->y_bottom
                                : of.piece->y_top <= top && bottom <= of.piece->y_bottom;
    if (!spans) continue;
    const double x = crowded_ ? x_at(of, middle, row) : mean_x(of, top, bottom, row);
    strands_.push_back({clamp_to(x, 0, 1), of.seen, of.direction});
  }
  std::sort(strands_.begin(), strands_.end(),
            [](const Strand& a, const Strand& b) { return a.x < b.x; });
}

void PixelArea::add_slab(SeenItems& seen, double height, const Light& background) {
  Light light = seen.composed(background);
  double from = 0;
  const bool few = strands_.size() * seen.items.size() <= kPlaces * kPlaces;
  const auto add = [&](double to) {
    const double area = height * (to - from);
    for (std::size_t c = 0; c < 4; ++c) sum_[c] += area * static_cast<double>(light[c]);
    from = to;
  };
  for (const Strand& strand : strands_) {
    if (!seen.change(strand.seen, strand.direction)) continue;
    add(few ? strand.x : place_before(strand.x));
    if (few || &strand == &strands_.back() || place_before((&strand + 1)->x) > from)
      light = seen.composed(background);
  }
  add(1);
  for (const Strand& strand : strands_) seen.change(strand.seen, -strand.direction);
}

Light PixelArea::mean(std::vector<PieceOf>& pieces, SeenItems& seen, int row,
                      const Light& background) {
  crowded_ = is_crowd(pieces);
  find_cuts(pieces, row);
  sum_ = {};
  double past = -1;  // left changes up to here are in the winding numbers
  for (std::size_t i = 1; i < cuts_.size(); ++i) {
    const double top = cuts_[i - 1], bottom = cuts_[i];
    if (!(bottom > top)) continue;
    const double reached = crowded_ ? 0.5 * (top + bottom) : bottom;
    for (const PieceOf& of : pieces)
      if (const int change = left_change(of, past, reached); change != 0)
        seen.change(of.seen, change);
    past = reached;
    find_strands(pieces, top, bottom, row);
    add_slab(seen, bottom - top, background);
  }
  Light mean;
  for (std::size_t c = 0; c < 4; ++c) mean[c] = static_cast<float>(sum_[c]);
  return mean;
}

}  // namespace flatray
