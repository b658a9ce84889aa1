#include "render/band_scan.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace flatray {
namespace {

// Rows that are taken at once: what waits in them stays in the caches.
int rows_at_once(std::size_t items) {
  constexpr std::size_t kItemRows = std::size_t{1} << 15;
  return static_cast<int>(std::max<std::size_t>(kItemRows / (items + 1), 4));
}

int rays_of(const DrawList& list) {
  return list.coverage == Coverage::area ? 0 : list.coverage == Coverage::rows ? list.rows : 1;
}

// The pixels of a box that something within bounds may show in.
PixelBox within(const PixelBox& box, const Bounds& bounds) {
  const auto low = [](double v, int a, int b) {
    return v > a ? static_cast<int>(std::min<double>(v, b)) : a;
  };
  const auto high = [](double v, int a, int b) {
    return v < b ? static_cast<int>(std::ceil(std::max<double>(v, a))) : b;
  };
  const int x = low(bounds.low.x(), box.x, box.right()),
            y = low(bounds.low.y(), box.y, box.bottom());
  return {x, y, high(bounds.high.x(), box.x, box.right()) - x,
          high(bounds.high.y(), box.y, box.bottom()) - y};
}

}  // namespace

BandScan::BandScan(const DrawList& list, bool hide, bool (*stop)())
    : list_(list),
      hide_(hide),
      stop_(stop),
      rays_(rays_of(list)),
      background_(premultiplied(list.background)),
      edges_(list.width, list.height),
      windings_(static_cast<std::size_t>(std::max(rays_, 1))) {}

void BandScan::scan(const PixelBox& box, const Band& band, PixelSink& sink) {
  sink_ = &sink;
  looks_.clear();
  for (std::size_t i = 0; i < band.size(); ++i) {
    fetch(band, i);
    looks_.emplace_back(list_.items[band[i].item]);
  }
  hidden_ = band.size();
  const int at_once = rows_at_once(band.size());
  for (int top = box.y; top < box.bottom(); top += at_once) {
    box_ = {box.x, top, box.width, std::min(at_once, box.bottom() - top)};
    hidden_ = std::min(hidden_, take_items(band));
    for (int row = top; row < box_.bottom(); ++row) {
      if (stop_ != nullptr && stop_()) return;
      draw_row(row);
    }
  }
}

// Items of one band lie far from each other in memory.
void BandScan::fetch(const Band& band, std::size_t i) const {
  constexpr std::size_t kAhead = 8;
  if (i + 2 * kAhead < band.size()) __builtin_prefetch(&band[i + 2 * kAhead]);
  if (i + kAhead < band.size()) {
    const char* item = reinterpret_cast<const char*>(&list_.items[band[i + kAhead].item]);
    for (std::size_t at = 0; at < sizeof(DrawItem); at += 64) __builtin_prefetch(item + at);
  }
  if (const FillPath* path = std::get_if<FillPath>(&list_.items[band[i].item].region))
    for (std::size_t edge = 0; edge < std::min<std::size_t>(path->edges.size(), 8); edge += 2)
      __builtin_prefetch(&path->edges[edge]);
}

// Gives the number of the items that are hidden by those above in all of the box.
std::size_t BandScan::take_items(const Band& band) {
  const auto height = static_cast<std::size_t>(box_.height),
             width = static_cast<std::size_t>(box_.width);
  stride_ = (width + 63) / 64;
  words_.assign(height * stride_, {});
  rows_.resize(std::max(rows_.size(), height));
  bases_.resize(height * width);
  open_ = box_.height * box_.width;
  edges_.clear();
  cutter_.begin(box_, list_.coverage, rays_);
  for (std::size_t i = band.size(); i-- > 0;) {
    if (open_ == 0) return i + 1;
    const PixelBox rows = within(box_, band[i].bounds);
    if (rows.height <= 0 || is_settled(rows)) continue;
    cut_item(band, i);
    for (int row = rows.y; row < rows.bottom(); ++row) take_row(static_cast<std::uint32_t>(i), row);
  }
  return 0;
}

bool BandScan::is_settled(const PixelBox& box) const {
  if (box.width <= 0) return true;
  const auto begin = static_cast<std::size_t>(box.x - box_.x),
             end = begin + static_cast<std::size_t>(box.width);
  for (int row = box.y; row < box.bottom(); ++row)
    for (std::size_t i = begin / 64; i <= (end - 1) / 64; ++i)
      if ((bits_within(i, begin, end) & ~words_[first_word(row) + i].settled) != 0) return false;
  return true;
}

void BandScan::cut_item(const Band& band, std::size_t i) {
  ++scans_;
  edges_.drop();
  const Region& region = list_.items[band[i].item].region;
  if (const FillPath* path = std::get_if<FillPath>(&region)) {
    if (band[i].edges > 0)
      for (const std::uint32_t edge : band.edges(band[i]))
        edges_.add(path->edges[edge - band[i].first]);
    else
      for (const Segment& edge : path->edges) edges_.add(edge);
  } else if (const FillArcs* arcs = std::get_if<FillArcs>(&region)) {
    edges_.add(*arcs);
  } else {
    edges_.add(std::get<FillRing>(region));
  }
  for (const ScanEdge& edge : edges_.edges()) cutter_.cut(edge);
}

// The cuts of one item from left to right. Most often two are apart, and between them the item
// covers all.
void BandScan::take_row(std::uint32_t item, int row) {
  RowCuts& work = cutter_.row(row);
  if (work.cuts.empty() && work.left.empty()) return;
  std::fill(windings_.begin(), windings_.end(), 0);
  if (work.left.empty() && work.cuts.size() == 2) {
    const RowCut *left = &work.cuts[0], *right = &work.cuts[1];
    if (left->low > right->low) std::swap(left, right);
    if (left->high < right->low && left->whole && right->whole) {
      const int from = pass(item, row, *left);
      std::fill(windings_.begin(), windings_.end(), left->edge->direction);
      cover(item, row, from, right->low);
      pass(item, row, *right);
      return work.clear();
    }
  }
  for (const LeftOfRow& left : work.left)
    for (int ray = left.ray_begin; ray < left.ray_end; ++ray)
      windings_[static_cast<std::size_t>(ray)] += left.direction;
  take_cuts(item, row);
  work.clear();
}

// An edge that is alone in its pixels: where it is passed.
int BandScan::pass(std::uint32_t item, int row, const RowCut& cut) {
  if (cut.border) return cut.low;
  here_.assign(1, &cut);
  for (int column = cut.low; column <= cut.high; ++column) {
    add_part(item, row, column);
    if (rays_ == 0 && column == cut.first) wind(cut);
  }
  return cut.high + 1;
}

// Those that lie in one column are taken together, in the order of their edges.
void BandScan::take_cuts(std::uint32_t item, int row) {
  const std::vector<RowCut>& cuts = cutter_.row(row).cuts;
  order_.clear();
  for (const RowCut& cut : cuts) order_.push_back(&cut);
  std::sort(order_.begin(), order_.end(), [](const RowCut* a, const RowCut* b) {
    return a->low != b->low ? a->low < b->low : a < b;
  });
  here_.clear();
  int from = box_.x;
  for (auto next = order_.begin(); next != order_.end() || !here_.empty();) {
    const int column = here_.empty() ? (*next)->low : from;
    cover(item, row, from, column);
    for (; next != order_.end() && (*next)->low == column; ++next)
      if ((*next)->border)
        wind(**next);
      else
        here_.insert(std::upper_bound(here_.begin(), here_.end(), *next), *next);
    from = column;
    if (here_.empty()) continue;
    add_part(item, row, from++);
    for (const RowCut* cut : here_)
      if (rays_ > 0 ? cut->high == column : cut->first == column && cut->y_in == 0) wind(*cut);
    std::erase_if(here_, [&](const RowCut* cut) { return cut->high == column; });
  }
  cover(item, row, from, box_.right());
}

void BandScan::wind(const RowCut& cut) {
  for (int ray = cut.ray_begin; ray < cut.ray_end; ++ray)
    windings_[static_cast<std::size_t>(ray)] += cut.edge->direction;
}

// What an item covers of one pixel, from its windings at the left and the cuts in it.
void BandScan::add_part(std::uint32_t item, int row, int column) {
  const auto place = static_cast<std::size_t>(column - box_.x);
  const std::uint64_t bit = std::uint64_t{1} << (place % 64);
  Words& words = words_of(row)[place / 64];
  if ((words.settled & bit) != 0) return;
  words.waits |= bit;
  Row& waiting = row_of(row);
  std::vector<Piece>& pieces = waiting.pieces;
  const std::size_t first = pieces.size();
  const bool even = std::all_of(windings_.begin(), windings_.end(),
                                [&](int winding) { return winding == windings_[0]; });
  for (std::size_t ray = 0; !even && ray < windings_.size(); ++ray)
    if (windings_[ray] != 0)
      cutter_.add_upright(column, static_cast<int>(ray), 0, windings_[ray], pieces);
  for (const RowCut* cut : here_) cutter_.add_pieces(*cut, row, column, pieces);
  waiting.add_part(column, item, even ? windings_[0] : 0, first);
}

void BandScan::cover(std::uint32_t item, int row, int begin, int end) {
  if (begin >= end) return;
  const auto covered = std::count_if(windings_.begin(), windings_.end(),
                                     [&](int winding) { return looks_[item].covers(winding); });
  if (covered == 0) return;
  if (covered == std::ssize(windings_)) return cover_all(item, row, begin, end);
  for (int column = begin; column < end; ++column) add_part(item, row, column);
}

// Of an item that covers whole pixels: they are drawn where nothing waits and nothing below is seen.
void BandScan::cover_all(std::uint32_t item, int row, int begin, int end) {
  const ItemLook& look = looks_[item];
  const auto first = static_cast<std::size_t>(begin - box_.x);
  const auto last = static_cast<std::size_t>(end - box_.x);
  const std::size_t from = first / 64, to = (last - 1) / 64;
  Words* const words = words_of(row);
  Row& waiting = row_of(row);
  const bool settles = hide_ && look.opaque, plain = settles && !look.varies;
  const auto open = [&](std::size_t i) { return bits_within(i, first, last) & ~words[i].settled; };
  std::uint32_t* const bases = bases_of(row);
  const auto settle = [&](std::size_t i, std::uint64_t bits) {
    if (settles) words[i].settled |= bits;
  };
  if (!plain || waiting.shines)
    each_run(
        from, to, [&](std::size_t i) { return plain ? open(i) & words[i].shines : open(i); },
        [&](int b, int e) {
          waiting.add(EventKind::begin, box_.x + b, item);
          if (e < box_.width) waiting.add(EventKind::end, box_.x + e, item);
          if (settles) open_ -= e - b;
        });
  if (!plain) {
    waiting.shines = true;
    for (std::size_t i = from; i <= to; ++i) {
      const std::uint64_t bits = open(i);
      words[i].waits |= bits, words[i].shines |= bits;
      settle(i, bits);
    }
    return;
  }
  each_run(
      from, to,
      [&](std::size_t i) {
        const std::uint64_t bits = open(i), direct = bits & ~words[i].waits;
        for (std::uint64_t parts = bits & ~direct & ~words[i].shines; parts != 0;
             parts &= parts - 1) {
          const int at = static_cast<int>(64 * i) + std::countr_zero(parts);
          bases[static_cast<std::size_t>(at)] = item;
          --open_;
        }
        settle(i, bits);
        return direct;
      },
      [&](int b, int e) {
        sink_->run(row, box_.x + b, box_.x + e, look.light);
        open_ -= e - b;
      });
}

}  // namespace flatray
