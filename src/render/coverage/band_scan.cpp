#include "render/coverage/band_scan.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flatray {
namespace {

// Rows that are taken at once: what waits in them stays in the caches, and pieces of long paths in memory.
int rows_at_once(std::size_t items, std::size_t edges) {
  constexpr std::size_t kItemRows = std::size_t{1} << 15, kEdgesAnItem = 32;
  return static_cast<int>(std::max<std::size_t>(kItemRows / (items + edges / kEdgesAnItem + 1), 4));
}

std::size_t edges_of(const Region& region, const Band& band, const BandItem& item) {
  if (item.edges > 0) return band.edges(item).size();
  const FillPath* path = std::get_if<FillPath>(&region);
  return path == nullptr ? 0 : path->edges.size();
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
  const int x = low(bounds.low.x(), box.x, box.right());
  const int y = low(bounds.low.y(), box.y, box.bottom());
  return {x, y, high(bounds.high.x(), box.x, box.right()) - x,
          high(bounds.high.y(), box.y, box.bottom()) - y};
}

}  // namespace

BandScan::BandScan(const DrawList& list, bool hide, bool (*stop)())
    : list_(list),
      hide_(hide),
      stop_(stop),
      rays_(rays_of(list)),
      all_rays_(~std::uint64_t{0} >> (64 - std::max(rays_, 1))),
      background_(premultiplied(list.background)),
      edges_(list.width, list.height),
      windings_(static_cast<std::size_t>(std::max(rays_, 1))),
      area_(list.crowd) {}

void BandScan::scan(const PixelBox& box, const Band& band, PixelSink& sink) {
  sink_ = &sink;
  looks_.clear();
  std::size_t edges = 0;
  for (std::size_t i = 0; i < band.size(); ++i) {
    fetch(band, i);
    const DrawItem& item = list_.items[band[i].item];
    looks_.emplace_back(item);
    edges += edges_of(item.region, band, band[i]);
  }
  hidden_ = band.size();
  const int at_once = rows_at_once(band.size(), edges);
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
  const auto height = static_cast<std::size_t>(box_.height);
  const auto width = static_cast<std::size_t>(box_.width);
  stride_ = (width + 63) / 64;
  words_.assign(height * stride_, {});
  const std::uint64_t beyond = ~bits_within(stride_ - 1, 0, width);
  for (std::size_t row = 1; row <= height; ++row) words_[row * stride_ - 1].settled = beyond;
  lowest_.resize(height * width);
  covers_.resize(std::max(covers_.size(), height));
  parts_.clear(), pieces_.clear(), edges_.clear();
  cutter_.begin(box_, list_.coverage, rays_);
  std::size_t open = 0;  // no word before it is
  for (std::size_t i = band.size(); i-- > 0;) {
    while (open < words_.size() && ~words_[open].settled == 0) ++open;
    if (open == words_.size()) return i + 1;
    const PixelBox rows = within(box_, band[i].bounds);
    if (rows.height <= 0 || is_settled(rows)) continue;
    cut_item(band, i, rows);
    item_ = static_cast<std::uint32_t>(i);
    for (int row = rows.y; row < rows.bottom(); ++row) take_row(row);
  }
  return 0;
}

bool BandScan::is_settled(const PixelBox& box) const {
  if (box.width <= 0) return true;
  const std::size_t begin = place(box.x), end = place(box.right());
  for (int row = box.y; row < box.bottom(); ++row) {
    const Words* const words = words_.data() + static_cast<std::size_t>(row - box_.y) * stride_;
    for (std::size_t i = begin / 64; i <= (end - 1) / 64; ++i)
      if ((bits_within(i, begin, end) & ~words[i].settled) != 0) return false;
  }
  return true;
}

void BandScan::cut_item(const Band& band, std::size_t i, const PixelBox& rows) {
  ++scans_;
  edges_.drop();
  const Region& region = list_.items[band[i].item].region;
  if (const FillPath* path = std::get_if<FillPath>(&region)) {
    if (band[i].edges > 0)
      for (const std::uint32_t edge : band.edges(band[i]))
        edges_.add(path->edges[edge - band[i].first]);
    else
      for (const Segment& edge : path->edges)
        if (std::max(edge.a.y(), edge.b.y()) > rows.y &&
            std::min(edge.a.y(), edge.b.y()) < rows.bottom())
          edges_.add(edge);
  } else if (const FillArcs* arcs = std::get_if<FillArcs>(&region)) {
    edges_.add(*arcs);
  } else {
    edges_.add(std::get<FillRing>(region));
  }
  for (const ScanEdge& edge : edges_.edges()) cutter_.cut(edge, rows);
}

void BandScan::begin_row(int row) {
  const auto at = static_cast<std::size_t>(row - box_.y);
  row_ = row;
  row_words_ = words_.data() + at * stride_;
  row_lowest_ = lowest_.data() + at * static_cast<std::size_t>(box_.width);
  row_covers_ = &covers_[at];
}

// The cuts of one item from left to right: most often two, apart, each through all of the row.
void BandScan::take_row(int row) {
  std::vector<RowCut>& cuts = cutter_.row(row);
  if (cuts.empty()) return;
  begin_row(row);
  const auto all = [this](const RowCut& cut) {
    return cut.ray_end - cut.ray_begin == std::ssize(windings_);
  };
  const RowCut *left = &cuts.front(), *right = &cuts.back();
  if (right->low < left->low) std::swap(left, right);
  if (cuts.size() == 2 && left->high < right->low && all(*left) && all(*right)) {
    const ItemLook& look = looks_[item_];
    int winding = pass(*left, 0);
    if (look.covers(winding)) cover_all(left->high + 1, right->low);
    winding = pass(*right, winding);
    if (look.covers(winding)) cover_all(right->high + 1, box_.right());
  } else {
    take_columns(cuts);
  }
  cuts.clear();
}

// A cut that is alone in its pixels. Gives the winding number right of it.
int BandScan::pass(const RowCut& cut, int winding) {
  const RowCut* const cuts[] = {&cut};
  const int right = winding + (cut.winds ? cut.edge->direction : 0);
  if (cut.low > cut.high) return right;
  const std::size_t first = place(cut.low), last = place(cut.high);
  for (std::size_t i = first / 64; i <= last / 64; ++i)
    each_one(i, bits_within(i, first, last + 1) & ~row_words_[i].settled, [&](int at) {
      const int column = box_.x + at;
      add_part(column, {cut.first < column ? right : winding, all_rays_}, cuts);
    });
  return right;
}

// Those that lie in one column are taken together.
void BandScan::take_columns(const std::vector<RowCut>& cuts) {
  entries_.clear();
  for (std::size_t i = 0; i < cuts.size(); ++i)
    for (int column = cuts[i].low; column <= std::max(cuts[i].low, cuts[i].high); ++column)
      entries_.push_back(static_cast<std::uint64_t>(column) << 32 | i);
  const auto column_of = [](std::uint64_t entry) { return static_cast<int>(entry >> 32); };
  const auto wind = [this](const RowCut& cut) {
    for (int ray = cut.ray_begin; ray < cut.ray_end; ++ray)
      windings_[static_cast<std::size_t>(ray)] += cut.edge->direction;
  };
  int from = box_.x;
  std::sort(entries_.begin(), entries_.end());
  for (auto next = entries_.begin(); next != entries_.end();) {
    const int column = column_of(*next);
    cover(std::exchange(from, column), column);
    here_.clear();
    for (; next != entries_.end() && column_of(*next) == column; ++next) {
      const RowCut& cut = cuts[static_cast<std::uint32_t>(*next)];
      if (cut.high < cut.low)
        wind(cut);
      else
        here_.push_back(&cut);
    }
    if (here_.empty()) continue;
    add_part(from++, wound(), here_);
    for (const RowCut* cut : here_)
      if (cut->winds && cut->first == column) wind(*cut);
  }
  cover(from, box_.right());
  std::fill(windings_.begin(), windings_.end(), 0);
}

void BandScan::add_part(int column, const Wound& wound, std::span<const RowCut* const> cuts) {
  const std::size_t at = place(column);
  const std::uint64_t bit = std::uint64_t{1} << (at % 64);
  Words& words = row_words_[at / 64];
  if ((words.settled & bit) != 0) return;
  const std::size_t first = pieces_.size();
  if (wound.rays != all_rays_) add_windings(wound);
  const bool in_order = pieces_.size() == first && cuts.size() < 2;
  for (const RowCut* cut : cuts) cutter_.add_pieces(*cut, row_, column, pieces_);
  if (rays_ > 0 && !in_order)
    std::sort(pieces_.begin() + static_cast<std::ptrdiff_t>(first), pieces_.end(),
              [](const Piece& a, const Piece& b) {
                return a.ray != b.ray ? a.ray < b.ray : a.x_top < b.x_top;
              });
  const std::uint32_t above = (words.waits & bit) != 0 ? row_lowest_[at] : kNone;
  row_lowest_[at] = static_cast<std::uint32_t>(parts_.size());
  parts_.push_back({item_, above, wound, static_cast<std::uint32_t>(first),
                    static_cast<std::uint32_t>(pieces_.size() - first)});
  words.waits |= bit;
}

// The winding number at the left of a pixel: the first that is not 0, and the rays that have it.
BandScan::Wound BandScan::wound() const {
  const auto first = std::find_if(windings_.begin(), windings_.end(), [](int w) { return w != 0; });
  if (first == windings_.end()) return {0, all_rays_};
  std::uint64_t rays = 0;
  for (std::size_t ray = 0; ray < windings_.size(); ++ray)
    rays |= std::uint64_t{windings_[ray] == *first} << ray;
  return {*first, rays};
}

// Those of other rays as pieces at the left of the pixel.
void BandScan::add_windings(const Wound& wound) {
  for (std::size_t ray = 0; ray < windings_.size(); ++ray) {
    if (windings_[ray] == 0 || windings_[ray] == wound.winding) continue;
    Piece& piece = pieces_.emplace_back();
    piece.direction = windings_[ray];
    piece.ray = static_cast<std::int8_t>(ray);
  }
}

void BandScan::cover(int begin, int end) {
  constexpr int kFew = 8;
  std::uint64_t rays = 0;
  for (std::size_t ray = 0; ray < windings_.size(); ++ray)
    rays |= std::uint64_t{looks_[item_].covers(windings_[ray])} << ray;
  if (rays == 0) return;
  if (rays == all_rays_) return cover_all(begin, end);
  if (end - begin > kFew) return cover_rays(begin, end, rays, false);
  const Wound all = wound();
  for (int column = begin; column < end; ++column) add_part(column, all, {});
}

// Of an item that covers whole pixels: they are drawn where nothing below is seen.
void BandScan::cover_all(int begin, int end) {
  if (begin >= end) return;
  const ItemLook& look = looks_[item_];
  const bool settles = hide_ && look.opaque, plain = settles && !look.varies;
  if (!plain || !row_covers_->empty()) cover_rays(begin, end, all_rays_, plain);
  if (!settles) return;
  const std::size_t first = place(begin), last = place(end);
  const auto settle = [&](std::size_t i) {
    Words& words = row_words_[i];
    const std::uint64_t open = bits_within(i, first, last) & ~words.settled;
    const std::uint64_t drawn = open & ~words.shines;
    words.settled |= open;
    each_one(i, drawn & words.waits, [&](int at) { draw_part(at, &look); });
    return drawn & ~words.waits;
  };
  each_run(first / 64, (last - 1) / 64, settle,
           [&](int b, int e) { sink_->run(row_, box_.x + b, box_.x + e, look.light); });
}

// Pixels that are not settled, or of these what shines: there the item waits.
void BandScan::cover_rays(int begin, int end, std::uint64_t rays, bool shining) {
  if (begin >= end) return;
  const std::size_t first = place(begin), last = place(end);
  const auto bits = [&](std::size_t i) {
    const Words& words = row_words_[i];
    const std::uint64_t open = bits_within(i, first, last) & ~words.settled;
    return shining ? open & words.shines : open;
  };
  each_run(first / 64, (last - 1) / 64, bits, [&](int b, int e) {
    row_covers_->push_back({box_.x + b, true, item_, rays});
    if (e < box_.width) row_covers_->push_back({box_.x + e, false, item_, rays});
  });
  for (std::size_t i = first / 64; i <= (last - 1) / 64; ++i) row_words_[i].shines |= bits(i);
}

}  // namespace flatray
