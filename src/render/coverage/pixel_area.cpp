#include "render/coverage/pixel_area.h"

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
  const Piece& p = *of.piece;
  if (p.curve == nullptr) return p.x_top + of.slope * (0.5 * (top + bottom) - p.y_top);
  const double upper = x_at(of, top, row), lower = x_at(of, bottom, row);
  return 0.5 * (upper + lower) - p.curve->bow(lower - upper, bottom - top) / (bottom - top);
}

// Adds where two pieces cross one another, to some 2^-27: what is wrong beside a crossing is its square.
void add_crossings(const PieceOf& a, const PieceOf& b, int row, std::vector<double>& cuts) {
  constexpr int kSteps = 27;
  const double top = std::max(a.piece->y_top, b.piece->y_top);
  const double bottom = std::min(a.piece->y_bottom, b.piece->y_bottom);
  if (!(top < bottom) || a.right <= b.left || b.right <= a.left) return;
  const auto gap = [&](double y) { return x_at(a, y, row) - x_at(b, y, row); };
  const double first = gap(top), last = gap(bottom);
  if (a.piece->curve == nullptr && b.piece->curve == nullptr) {
    if (first * last < 0) cuts.push_back(top + (bottom - top) * (first / (first - last)));
    return;
  }
  // Where the gap changes its sign.
  const auto add = [&](double low, double high, bool rises) {
    for (int i = 0; i < kSteps; ++i) {
      const double middle = 0.5 * (low + high);
      ((gap(middle) < 0) == rises ? low : high) = middle;
    }
    cuts.push_back(0.5 * (low + high));
  };
  if (first * last < 0) return add(top, bottom, first < 0);
  if (std::min(std::abs(first), std::abs(last)) > 0x1p-40 + a.bend + b.bend) return;
  // Where a gap that is of one sign at both ends comes nearest to the other, by thirds.
  const double side = first + last;
  double low = top, high = bottom;
  for (int i = 0; i < kSteps; ++i) {
    const double third = (high - low) / 3, upper = low + third, lower = high - third;
    if (side * gap(upper) < side * gap(lower))
      high = lower;
    else
      low = upper;
  }
  const double middle = 0.5 * (low + high);
  if (!(side * gap(middle) < 0)) return;
  add(top, middle, first < 0);
  add(middle, bottom, last > 0);
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

// Whether more pieces pass by one another than `most` do among themselves. Sorts them.
bool is_crowd(std::vector<PieceOf>& pieces, std::size_t most) {
  const bool many = pieces.size() > most;
  if (many) join_equal(pieces);
  std::sort(pieces.begin(), pieces.end(),
            [](const PieceOf& a, const PieceOf& b) { return a.piece->y_top < b.piece->y_top; });
  if (!many) return false;
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (std::size_t k = i + 1;
         k < pieces.size() && pieces[k].piece->y_top < pieces[i].piece->y_bottom; ++k)
      if (++pairs > most * most / 2) return true;
  return pieces.size() > most * most / 2;
}

}  // namespace

PieceOf::PieceOf(const Piece& of, std::uint32_t item)
    : piece(&of), seen(item), direction(of.direction) {
  const double width = of.x_bottom - of.x_top, height = of.y_bottom - of.y_top;
  left = std::min(of.x_top, of.x_bottom);
  right = std::max(of.x_top, of.x_bottom);
  if (height < 0x1p-900) return;  // without area, too
  slope = width / height;
  if (of.curve != nullptr) bend = 2 * std::abs(of.curve->bow(width, height)) / height;
}

// Where the winding number along the left border changes: where an edge crosses it.
void PixelArea::find_lefts(std::span<const PieceOf> pieces) {
  lefts_.clear();
  for (const PieceOf& of : pieces) {
    if (of.piece->left_top) lefts_.push_back({of.piece->y_top, of.seen, -of.direction});
    if (of.piece->left_bottom) lefts_.push_back({of.piece->y_bottom, of.seen, of.direction});
  }
  std::sort(lefts_.begin(), lefts_.end(),
            [](const LeftChange& a, const LeftChange& b) { return a.y < b.y; });
}

// Between which the light is summed.
void PixelArea::find_cuts(std::span<const PieceOf> pieces, int row) {
  cuts_ = {0, 1};
  if (crowded_) {
    const std::size_t strips = std::max(2 * crowd_ * crowd_ / pieces.size(), crowd_);
    for (std::size_t i = 1; i < strips; ++i)
      cuts_.push_back(static_cast<double>(i) / static_cast<double>(strips));
  } else {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const Piece& piece = *pieces[i].piece;
      if (piece.y_top > 0) cuts_.push_back(piece.y_top);
      if (piece.y_bottom < 1) cuts_.push_back(piece.y_bottom);
      for (std::size_t k = 0; k < i; ++k) add_crossings(pieces[i], pieces[k], row, cuts_);
    }
  }
  std::sort(cuts_.begin(), cuts_.end());
}

// The pieces that pass through a slab, from left to right; in a crowd along its middle. Most of them
// are those of the slab above, in their order.
void PixelArea::find_strands(std::span<const PieceOf> pieces, double top, double bottom, int row) {
  const double middle = 0.5 * (top + bottom);
  const double begun = crowded_ ? middle : top;
  std::erase_if(strands_, [&](const Strand& strand) {
    const double end = strand.of->piece->y_bottom;
    return crowded_ ? end <= middle : end < bottom;
  });
  for (; next_ < pieces.size() && pieces[next_].piece->y_top <= begun; ++next_) {
    const double end = pieces[next_].piece->y_bottom;
    if (crowded_ ? middle < end : bottom <= end) strands_.push_back({0, &pieces[next_]});
  }
  for (auto& [x, of] : strands_)
    x = clamp_to(crowded_ ? x_at(*of, middle, row) : mean_x(*of, top, bottom, row), 0, 1);
  std::sort(strands_.begin(), strands_.end(),
            [](const Strand& a, const Strand& b) { return a.x < b.x; });
}

// The strands whose lights are not those of the slab above: most often two changed their places.
PixelArea::Stretch PixelArea::strands_to_light() const {
  const std::size_t count = strands_.size(), known = lit_.size();
  const auto same = [this](std::size_t i, std::size_t k) {
    return strands_[i].of->seen == lit_[k].seen && strands_[i].of->direction == lit_[k].direction;
  };
  std::size_t begin = 0;
  while (begin < std::min(count, known) && same(begin, begin)) ++begin;
  if (count != known || begin == count) return {begin, count};
  if (begin + 1 == count || !same(begin, begin + 1) || !same(begin + 1, begin))
    return {begin, count};
  std::size_t end = count;
  while (end > begin + 2 && same(end - 1, end - 1)) --end;
  return {begin, end == begin + 2 ? end : count};
}

// Where several strands lie in one place, what is between them has no area.
void PixelArea::light_strands(SeenItems& seen, const Stretch& stretch) {
  lit_.resize(strands_.size());
  Light light = left_;
  bool changed = true;
  for (std::size_t i = 0; i < stretch.end; ++i) {
    const auto& [x, of] = strands_[i];
    changed = seen.change(of->seen, of->direction) || changed;
    if (i < stretch.begin) continue;
    if (changed && !(crowded_ && i + 1 < stretch.end && strands_[i + 1].x == x)) {
      light = seen.composed();
      changed = false;
    }
    lit_[i] = {light, of->seen, of->direction};
  }
  for (std::size_t i = 0; i < stretch.end; ++i)
    seen.change(strands_[i].of->seen, -strands_[i].of->direction);
}

void PixelArea::add_slab(double height) {
  double from = 0;
  const auto add = [&](double to, const Light& light) {
    sum_.add(height * (to - from), light);
    from = to;
  };
  add(strands_.empty() ? 1 : strands_.front().x, left_);
  for (std::size_t i = 0; i < strands_.size(); ++i)
    add(i + 1 < strands_.size() ? strands_[i + 1].x : 1, lit_[i].light);
}

Light PixelArea::mean(std::vector<PieceOf>& pieces, SeenItems& seen, int row) {
  const auto places = static_cast<double>(2 * crowd_);
  crowded_ = is_crowd(pieces, crowd_);
  find_lefts(pieces);
  find_cuts(pieces, row);
  strands_.clear();
  next_ = 0;
  sum_ = {};
  bool afresh = true;          // nothing of the slab above holds
  auto left = lefts_.begin();  // the first that is not in the winding numbers
  for (std::size_t i = 1; i < cuts_.size(); ++i) {
    const double top = cuts_[i - 1], bottom = cuts_[i];
    if (!(bottom > top)) continue;
    const double reached = crowded_ ? 0.5 * (top + bottom) : bottom;
    afresh = afresh || crowded_;
    for (; left != lefts_.end() && left->y < reached; ++left) {
      seen.change(left->seen, left->direction);
      afresh = true;
    }
    find_strands(pieces, top, bottom, row);
    // In few places, so that few lights are asked for.
    if (crowded_ && strands_.size() * seen.items.size() > 4 * crowd_ * crowd_)
      for (Strand& strand : strands_) strand.x = std::floor(strand.x * places) / places;
    if (afresh) {
      left_ = seen.composed();
      lit_.clear();
      afresh = false;
    }
    light_strands(seen, strands_to_light());
    add_slab(bottom - top);
  }
  return sum_.over(1);
}

}  // namespace flatray
