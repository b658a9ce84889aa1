#include "render/coverage/band_scan.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <utility>

namespace flatray {
namespace {

constexpr std::uint32_t kNone = 0xffffffffU;

// Rows that are cut before they are drawn: the pieces of edges stay in the caches.
int rows_at_once(std::size_t items) {
  constexpr std::size_t kItemRows = std::size_t{1} << 15;
  return static_cast<int>(std::max<std::size_t>(kItemRows / (items + 1), 4));
}

int rays_of(const DrawList& list) {
  return list.coverage == Coverage::area ? 0 : list.coverage == Coverage::rows ? list.rows : 1;
}

Light mixed(const Light& a, const Light& b, double share) {
  Light mean;
  for (std::size_t c = 0; c < 4; ++c)
    mean[c] = static_cast<float>(share * static_cast<double>(a[c]) +
                                 (1 - share) * static_cast<double>(b[c]));
  return mean;
}

}  // namespace

void BandScan::Stack::change(std::uint32_t item, int by) {
  auto at = entries_.end();
  while (at != entries_.begin() && (at - 1)->item > item) --at;
  if (at == entries_.begin() || (at - 1)->item != item) {
    entries_.insert(at, {item, by});
  } else if (((at - 1)->winding += by) == 0) {
    entries_.erase(at - 1);
  }
}

void BandScan::Stack::merge(std::span<const Entry> changes) {
  merged_.clear();
  auto below = entries_.begin();
  for (auto one = changes.rbegin(); one != changes.rend(); ++one) {
    while (below != entries_.end() && below->item <= one->item) merged_.push_back(*below++);
    if (merged_.empty() || merged_.back().item != one->item)
      merged_.push_back(*one);
    else if ((merged_.back().winding += one->winding) == 0)
      merged_.pop_back();
  }
  merged_.insert(merged_.end(), below, entries_.end());
  std::swap(entries_, merged_);
}

void BandScan::Stack::change(std::span<const Entry> changes, std::span<const ItemLook> looks) {
  constexpr std::size_t kFew = 8;
  if (changes.empty()) return;
  if (changes.size() > kFew)
    merge(changes);
  else
    for (const auto& [item, by] : changes) change(item, by);
  if (changes.front().item < shown_from_) return;
  shown_from_ = 0;
  for (auto entry = entries_.rbegin(); entry != entries_.rend() && shown_from_ == 0; ++entry)
    if (looks[entry->item].opaque && looks[entry->item].covers(entry->winding))
      shown_from_ = entry->item;
}

BandScan::BandScan(const DrawList& list, bool hide, bool (*stop)())
    : list_(list),
      hide_(hide),
      stop_(stop),
      rays_(rays_of(list)),
      background_(premultiplied(list.background)),
      edges_(list.width, list.height),
      stacks_(static_cast<std::size_t>(std::max(rays_, 1))) {}

void BandScan::scan(const PixelBox& box, const Band& band, PixelSink& sink) {
  sink_ = &sink;
  looks_.clear();
  for (std::size_t i = 0; i < band.size(); ++i) looks_.emplace_back(list_.items[band[i].item]);
  slots_.resize(band.size());
  hidden_ = band.size();
  const int at_once = rows_at_once(band.size());
  for (int top = box.y; top < box.bottom(); top += at_once) {
    box_ = {box.x, top, box.width, std::min(at_once, box.bottom() - top)};
    hidden_ = std::min(hidden_, cut(band));
    for (int row = top; row < box_.bottom(); ++row) {
      if (stop_ != nullptr && stop_()) return;
      scan_row(row);
    }
  }
}

std::size_t BandScan::cut(const Band& band) {
  edges_.clear();
  cutter_.begin(box_, list_.coverage, rays_);
  for (std::size_t i = band.size(); i-- > 0;) {
    const Bounds& bounds = band[i].bounds;
    if (bounds.low.y() >= box_.bottom() || bounds.high.y() <= box_.y) continue;
    const std::size_t before = cutter_.pieces();
    cut_item(band, i);
    const bool whole = looks_[i].opaque && cutter_.pieces() == before && band[i].may_cover(box_);
    if (hide_ && whole && hides_all(static_cast<std::uint32_t>(i))) return i;
  }
  return 0;
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
  for (const ScanEdge& edge : edges_.edges()) cutter_.cut(edge, static_cast<std::uint32_t>(i));
}

// Of an item without a piece in the box, cut last: whether its winding number covers each ray.
bool BandScan::hides_all(std::uint32_t item) {
  for (int row = box_.y; row < box_.bottom(); ++row) {
    std::vector<int> windings(stacks_.size());
    const std::vector<LeftOfRow>& left = cutter_.row(row).left;
    for (auto change = left.rbegin(); change != left.rend() && change->item == item; ++change)
      windings[static_cast<std::size_t>(change->ray)] += change->direction;
    for (const int winding : windings)
      if (!looks_[item].covers(winding)) return false;
  }
  return true;
}

void BandScan::scan_row(int row) {
  const RowPieces& work = cutter_.row(row);
  for (std::size_t ray = 0; ray < stacks_.size(); ++ray) {
    changes_.clear();
    for (const LeftOfRow& left : work.left)
      if (static_cast<std::size_t>(left.ray) == ray)
        changes_.push_back({left.item, left.direction});
    stacks_[ray].clear();
    stacks_[ray].change(changes_, looks_);
  }
  gather_columns(work.pieces);
  run_ = box_.x;
  for (std::size_t word = 0; word < touched_.size(); ++word)
    for (std::uint64_t bits = std::exchange(touched_[word], 0); bits != 0; bits &= bits - 1) {
      of_column_.clear();
      const std::size_t place = 64 * word + static_cast<std::size_t>(std::countr_zero(bits));
      for (std::uint32_t i = first_of_[place]; i != kNone; i = next_[i])
        of_column_.push_back(&work.pieces[i]);
      take_column(of_column_, row);
    }
  put_run(row, box_.right());
}

// Lists of the pieces in each column, in the order in which they were cut.
void BandScan::gather_columns(std::span<const Piece> pieces) {
  const auto width = static_cast<std::size_t>(box_.width);
  first_of_.resize(width);
  touched_.resize((width + 63) / 64);
  next_.resize(std::max(next_.size(), pieces.size()));
  for (std::size_t i = pieces.size(); i-- > 0;) {
    const auto place = static_cast<std::size_t>(pieces[i].column - box_.x);
    const std::uint64_t bit = std::uint64_t{1} << (place % 64);
    next_[i] = (touched_[place / 64] & bit) != 0 ? first_of_[place] : kNone;
    touched_[place / 64] |= bit;
    first_of_[place] = static_cast<std::uint32_t>(i);
  }
}

// Draws the pixel of the pieces if they show something in it. Pieces along all of its left border
// change what is in it, but cut nothing.
void BandScan::take_column(std::vector<const Piece*>& pieces, int row) {
  const int column = pieces.front()->column;
  const auto cuts = [this](const Piece* p) {
    return p->x_top != 0 || (rays_ == 0 && (p->x_bottom != 0 || p->y_top != 0 || p->y_bottom != 1));
  };
  bool shown = false;
  std::size_t cut = 0;
  for (const Piece* piece : pieces) {
    shown = shown || piece->item >= stacks_[static_cast<std::size_t>(piece->ray)].shown_from();
    cut += cuts(piece) ? 1 : 0;
  }
  if (!shown) return enter(pieces);
  put_run(row, column);
  if (cut == 0) return enter(pieces);
  run_ = column + 1;
  if (rays_ > 0) return sink_->pixel(row, column, mean_of_rays(pieces, row));
  if (cut < pieces.size()) {
    std::vector<const Piece*> borders;
    std::copy_if(pieces.begin(), pieces.end(), std::back_inserter(borders), std::not_fn(cuts));
    std::erase_if(pieces, std::not_fn(cuts));
    enter(borders);
  }
  sink_->pixel(row, column, area_of(pieces, row));
  enter(pieces);
}

// Goes on right of pieces.
void BandScan::enter(std::span<const Piece* const> pieces) {
  changes_.clear();
  for (const Piece* piece : pieces) {
    const Stack::Entry change{piece->item, piece->direction};
    if (rays_ > 0)
      stacks_[static_cast<std::size_t>(piece->ray)].change({&change, 1}, looks_);
    else if (piece->crosses_top)
      changes_.push_back(change);
  }
  stacks_[0].change(changes_, looks_);
}

// From where the row is drawn so far.
void BandScan::put_run(int row, int end) {
  const int begin = std::exchange(run_, end);
  if (begin >= end) return;
  bool varies = false;
  const Light light = light_of_stacks(row, begin, varies);
  if (!varies) return sink_->run(row, begin, end, light);
  sink_->pixel(row, begin, light);
  for (int x = begin + 1; x < end; ++x) sink_->pixel(row, x, light_of_stacks(row, x, varies));
}

Light BandScan::light_of_stacks(int row, int column, bool& varies) {
  const Light first = light_of(stacks_[0], row, column, varies);
  if (stacks_.size() == 1) return first;
  std::array<double, 4> sum{};
  bool alike = true;
  for (const Stack& stack : std::span(stacks_).subspan(1)) {
    const Light light = light_of(stack, row, column, varies);
    alike = alike && light == first;
    for (std::size_t c = 0; c < 4; ++c) sum[c] += static_cast<double>(light[c]);
  }
  if (alike) return first;
  Light mean;
  for (std::size_t c = 0; c < 4; ++c)
    mean[c] = static_cast<float>((static_cast<double>(first[c]) + sum[c]) / rays_);
  return mean;
}

Light BandScan::light_of(const Stack& stack, int row, int column, bool& varies) {
  const std::span<const Stack::Entry> entries = stack.entries();
  if (entries.empty()) return background_;
  const ItemLook& look = looks_[entries.back().item];
  if (look.opaque && !look.varies && look.covers(entries.back().winding)) return look.light;
  cut_items_.clear();
  see(stack, row, column);
  for (const Seen& one : seen_.items) varies = varies || one.look->varies;
  return seen_.composed(background_);
}

Light BandScan::mean_of_rays(std::span<const Piece*> pieces, int row) {
  const int column = pieces.front()->column;
  std::sort(pieces.begin(), pieces.end(), [](const Piece* a, const Piece* b) {
    return a->ray != b->ray       ? a->ray < b->ray
           : a->x_top != b->x_top ? a->x_top < b->x_top
                                  : std::less<>()(a, b);
  });
  std::array<double, 4> sum{};
  bool varies = false;
  auto next = pieces.begin();
  for (std::size_t ray = 0; ray < stacks_.size(); ++ray) {
    double from = 0;
    const auto add = [&](double to) {
      if (from == to) return;
      const Light light = light_of(stacks_[ray], row, column, varies);
      for (std::size_t c = 0; c < 4; ++c) sum[c] += (to - from) * static_cast<double>(light[c]);
      from = to;
    };
    for (; next != pieces.end() && static_cast<std::size_t>((*next)->ray) == ray; ++next) {
      add((*next)->x_top);
      const Stack::Entry change{(*next)->item, (*next)->direction};
      stacks_[ray].change({&change, 1}, looks_);
    }
    add(1);
  }
  Light mean;
  for (std::size_t c = 0; c < 4; ++c) mean[c] = static_cast<float>(sum[c] / rays_);
  return mean;
}

// What may be seen in a pixel of the stack's items and those cut in it, from the lowest up: none
// below one that hides all of the pixel.
void BandScan::see(const Stack& stack, int row, int column) {
  std::vector<Seen>& items = seen_.items;
  items.clear();
  const std::span<const Stack::Entry> entries = stack.entries();
  auto below = entries.rbegin();
  auto cut = cut_items_.begin();
  while (below != entries.rend() || cut != cut_items_.end()) {
    const bool is_cut = cut != cut_items_.end() && (below == entries.rend() || *cut >= below->item);
    const std::uint32_t item = is_cut ? *cut : below->item;
    const bool wound = below != entries.rend() && below->item == item;
    const int winding = wound ? below->winding : 0;
    if (wound) ++below;
    if (is_cut) ++cut;
    const ItemLook& look = looks_[item];
    const bool inside = look.covers(winding);
    if (!is_cut && !inside) continue;
    const Light light = look.varies ? look.at(column, row, list_.width) : look.light;
    items.push_back({&look, item, winding, light});
    if (look.opaque && !is_cut) break;
  }
  std::reverse(items.begin(), items.end());
  seen_.place_all();
}

// Of an opaque item of one colour in part over what is so, too, which most pixels show.
std::optional<Light> BandScan::plain_area_of(std::span<const Piece* const> pieces) const {
  const std::uint32_t item = pieces.front()->item;
  const ItemLook& look = looks_[item];
  if (pieces.back()->item != item || !look.opaque || !look.simple || look.varies) return {};
  Light below = background_;
  int winding = 0;
  const std::span<const Stack::Entry> entries = stacks_[0].entries();
  for (auto entry = entries.rbegin(); entry != entries.rend(); ++entry) {
    const ItemLook& other = looks_[entry->item];
    if (entry->item == item) {
      winding = entry->winding;
    } else if (other.covers(entry->winding)) {
      if (entry->item > item || !other.opaque || other.varies) return {};
      below = other.light;
      break;
    }
  }
  double wound = 0;  // added up as for part_covered, to the bit
  for (const Piece* piece : pieces) wound += area_right_of(*piece);
  return mixed(look.light, below, std::min(std::abs(winding + wound), 1.0));
}

Light BandScan::area_of(std::span<const Piece* const> pieces, int row) {
  if (const auto plain = plain_area_of(pieces)) return *plain;
  cut_items_.clear();  // cut from the uppermost down, so that equal ones are neighbours
  for (const Piece* piece : pieces)
    if (cut_items_.empty() || cut_items_.back() != piece->item) cut_items_.push_back(piece->item);
  see(stacks_[0], row, pieces.front()->column);
  for (std::uint32_t i = 0; i < seen_.items.size(); ++i) slots_[seen_.items[i].item] = i;
  pieces_.clear();
  bool one_item = true;
  for (const Piece* piece : pieces) {
    if (piece->item < seen_.items.front().item) continue;  // hidden
    pieces_.emplace_back(*piece, slots_[piece->item]);
    one_item = one_item && pieces_.back().seen == pieces_.front().seen;
  }
  if (pieces_.empty()) return seen_.composed(background_);
  const std::size_t at = pieces_.front().seen;
  if (!one_item || !(seen_.items[at].look->simple || pieces_.size() == 1))
    return area_.mean(pieces_, seen_, row, background_);
  double wound = 0;
  for (const PieceOf& of : pieces_) wound += area_right_of(*of.piece);
  return part_covered(at, wound);
}

// A pixel with one item in part: simple, or parted by one edge into two winding numbers.
Light BandScan::part_covered(std::size_t at, double wound) {
  const Seen& one = seen_.items[at];
  double share = std::min(std::abs(one.winding + wound), 1.0);
  if (!one.look->simple) {
    const bool here = one.covered(), there = one.look->covers(one.winding + (wound > 0 ? 1 : -1));
    const double other = std::min(std::abs(wound), 1.0);
    share = here == there ? (here ? 1 : 0) : here ? 1 - other : other;
  }
  seen_.set(at, true);
  const Light with = seen_.composed(background_);
  seen_.set(at, false);
  const Light without = seen_.composed(background_);
  return mixed(with, without, share);
}

}  // namespace flatray
