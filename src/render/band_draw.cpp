// What BandScan draws of a row when all items are known.
#include <algorithm>
#include <cmath>

#include "render/band_scan.h"

namespace flatray {
namespace {

Light mixed(const Light& a, const Light& b, double share) {
  Light mean;
  for (std::size_t c = 0; c < 4; ++c)
    mean[c] = static_cast<float>(share * static_cast<double>(a[c]) +
                                 (1 - share) * static_cast<double>(b[c]));
  return mean;
}

}  // namespace

// What waits in a row, and the background.
void BandScan::draw_row(int row) {
  const std::vector<Event>& events = row_of(row).events;
  const Words* const words = words_of(row);
  active_.clear();
  int from = box_.x;
  columns_.each(std::span<const Event>(events), box_.x, box_.width,
                [&](std::span<const std::uint32_t> of_column) {
                  const int column = events[of_column.front()].column;
                  draw_run(row, from, column);
                  from = column;
                  for (const std::uint32_t i : of_column) activate(events[i]);
                  if (parts_.empty()) return;
                  const auto place = static_cast<std::size_t>(column - box_.x);
                  const Words& w = words[place / 64];
                  const bool based = ((w.settled & ~w.shines) >> (place % 64) & 1) != 0;
                  base_ = based ? bases_of(row)[place] : kNone;
                  sink_->pixel(row, column, light_of_parts(row));
                  parts_.clear();
                  base_ = kNone;
                  ++from;
                });
  draw_run(row, from, box_.right());
  each_run(
      0, stride_ - 1,
      [&](std::size_t i) {
        return bits_within(i, 0, static_cast<std::size_t>(box_.width)) &
               ~(words[i].settled | words[i].waits);
      },
      [&](int b, int e) { sink_->run(row, box_.x + b, box_.x + e, background_); });
  row_of(row).clear();
}

void BandScan::activate(const Event& event) {
  if (event.kind == EventKind::part) return parts_.push_back(&event);
  const auto at = std::lower_bound(active_.begin(), active_.end(), event.item, std::greater<>());
  if (event.kind == EventKind::begin)
    active_.insert(at, event.item);
  else
    active_.erase(at);
}

// Pixels that wait, covered by whole items alone.
void BandScan::draw_run(int row, int begin, int end) {
  if (begin >= end || active_.empty()) return;
  see(row, begin);
  const bool varies = std::any_of(seen_.items.begin(), seen_.items.end(),
                                  [](const Seen& one) { return one.look->varies; });
  if (!varies) return sink_->run(row, begin, end, seen_.composed(background_));
  sink_->pixel(row, begin, seen_.composed(background_));
  for (int x = begin + 1; x < end; ++x)
    see(row, x), sink_->pixel(row, x, seen_.composed(background_));
}

// What may be seen in a pixel, from the lowest item up: none below one that hides all of the pixel.
// Of the parts the pieces, those of the uppermost first.
void BandScan::see(int row, int column) {
  std::vector<Seen>& items = seen_.items;
  items.clear();
  pieces_.clear();
  const auto add = [&](std::uint32_t item, int winding) {
    const ItemLook& look = looks_[item];
    const Light light = look.varies ? look.at(column, row, list_.width) : look.light;
    items.push_back({&look, item, winding, light});
    return look.opaque;
  };
  const std::vector<Piece>& all = row_of(row).pieces;
  auto whole = active_.begin();
  auto part = parts_.begin();
  bool hidden = false;
  while (!hidden && (whole != active_.end() || part != parts_.end())) {
    if (part == parts_.end() || (whole != active_.end() && *whole > (*part)->item)) {
      hidden = add(*whole++, 1);
      continue;
    }
    const auto at = static_cast<std::uint32_t>(items.size());
    for (std::uint32_t i = 0; i < (*part)->count; ++i)
      pieces_.emplace_back(all[(*part)->first + i], at);
    add((*part)->item, (*part)->winding);
    ++part;
  }
  if (!hidden && base_ != kNone) add(base_, 1);
  std::reverse(items.begin(), items.end());
  for (PieceOf& of : pieces_) of.seen = static_cast<std::uint32_t>(items.size()) - 1 - of.seen;
  seen_.place_all();
}

// Of a pixel with one item in part, if it is simple or parted by one edge into two winding numbers:
// the mean of its light with and without the item.
Light BandScan::light_of_parts(int row) {
  const Event& part = *parts_.front();
  const ItemLook& look = looks_[part.item];
  if (active_.empty() && parts_.size() == 1 && look.opaque && look.simple && !look.varies) {
    double wound = 0;
    for (const Piece& piece : std::span(row_of(row).pieces).subspan(part.first, part.count))
      wound += area_right_of(piece);
    const Light& below = base_ == kNone ? background_ : looks_[base_].light;
    return mixed(look.light, below, std::min(std::abs(part.winding + wound), 1.0));
  }
  see(row, part.column);
  if (pieces_.empty()) return seen_.composed(background_);
  const std::uint32_t at = pieces_.front().seen;
  const bool one_item =
      std::all_of(pieces_.begin(), pieces_.end(), [&](const PieceOf& of) { return of.seen == at; });
  if (!one_item || !(seen_.items[at].look->simple || (pieces_.size() == 1 && rays_ == 0)))
    return rays_ > 0 ? area_.mean_of_rays(pieces_, seen_, rays_, background_)
                     : area_.mean(pieces_, seen_, row, background_);
  double wound = 0;
  for (const PieceOf& of : pieces_) wound += area_right_of(*of.piece);
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
  return mixed(with, seen_.composed(background_), share);
}

}  // namespace flatray
