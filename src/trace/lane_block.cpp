#include "trace/lane_block.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <numeric>
#include <type_traits>
#include <utility>

namespace flatray {
namespace {

constexpr std::size_t kVector = 16;  // floats that kernels take at once, at most
constexpr std::size_t kColumns = 11;

// The word of an answer that lanes::Finish writes, before its t.
static_assert(sizeof(NearestHit) == 16 && offsetof(NearestHit, surface) == 0 &&
              offsetof(NearestHit, t) == 8 && std::is_trivially_copyable_v<NearestHit>);
unsigned long word_of(std::uint32_t surface, HitClass kind) {
  const NearestHit hit{surface, kind, Root::none, false, 0};
  unsigned long word = 0;
  std::memcpy(&word, &hit, sizeof word);
  return word;
}

// Columns of some rays one after the other, `room` floats each.
lanes::Walking columns_of(float* column, const float* numbers, std::size_t room) {
  lanes::Walking w{};
  w.number = numbers;
  for (float** each : {&w.ox, &w.oy, &w.dx, &w.dy, &w.inverse_x, &w.inverse_y, &w.departed_ax,
                       &w.departed_ay, &w.departed_bx, &w.end_low, &w.end_high})
    *each = std::exchange(column, column + room);
  return w;
}

}  // namespace

LaneBlock::LaneBlock(const Surfaces& walls, const lanes::WalkKernels& kernels, std::size_t most)
    : walls_(walls),
      kernels_(kernels),
      room_(RayBlock::whole_vectors(most) + kVector),
      numbers_(room_),
      columns_(kColumns * room_),
      departed_(room_),
      roots_(room_),
      fate_(room_),
      found_(room_),
      open_(room_),
      ends_(room_),
      times_(room_) {
  std::iota(numbers_.begin(), numbers_.end(), 0.0F);
}

void LaneBlock::load(const RayBatch& rays, std::size_t begin, std::size_t count) {
  rays_ = &rays;
  begin_ = begin;
  count_ = count;
  given_ = whole_.take(rays, begin, count);
}

std::span<const int> LaneBlock::walk(const LaneCells& cells, Asked asked) {
  const lanes::Grid& grid = cells.grid;
  lanes::Walking w = columns_of(columns_.data(), numbers_.data(), room_);
  w.count = static_cast<int>(count_);
  if (asked != Asked::first) w.up_to = ends_.data();
  w.is_first = asked == Asked::first_before_end;
  // finish() reads whole vectors, and what was found last may be no slot of these cells.
  std::fill(found_.begin() + static_cast<std::ptrdiff_t>(count_), found_.end(), lanes::kNoRecord);
  bool some_unable = false;
  if (some_have_left()) {
    some_unable = find_left(cells.cells);
    w.departed = departed_.data();
    w.roots = roots_.data();
  }
  some_unable = kernels_.prepare(grid, given_, w, fate_.data()) || some_unable;
  (grid.cells != nullptr ? kernels_.walk : kernels_.scan)(grid, w, found_.data());
  for (std::size_t i = 0; some_unable && i < room_; ++i)
    if (std::exchange(fate_[i], 0) != 0) found_[i] = lanes::kDoubt;
  return {found_.data(), count_};
}

std::span<const int> LaneBlock::finish(const LaneCells& cells, NearestHit* hits) {
  const int open =
      kernels_.finish(cells.grid, given_,
                      {found_.data(), static_cast<int>(count_), hits, word_of(0, HitClass::touch),
                       word_of(kNoSurface, HitClass::miss), open_.data()});
  return {open_.data(), static_cast<std::size_t>(open)};
}

void LaneBlock::finish_curves(const LaneCells& cells, NearestHit* hits) {
  int count = 0;
  for (std::size_t i = 0; i < count_; ++i)
    if (found_[i] >= 0) open_[static_cast<std::size_t>(count++)] = static_cast<int>(i);
  kernels_.finish_curves(cells.grid, given_, {open_.data(), found_.data(), count, times_.data()});
  for (int k = 0; k < count; ++k) {
    const auto ray = static_cast<std::size_t>(open_[static_cast<std::size_t>(k)]);
    const auto slot = static_cast<std::size_t>(found_[ray] & ~lanes::kSecond);
    const Root root = (found_[ray] & lanes::kSecond) != 0 ? Root::second : Root::first;
    hits[ray] = {walls_.curve_numbers[slot], HitClass::through, root, false,
                 times_[static_cast<std::size_t>(k)]};
  }
}

bool LaneBlock::some_have_left() const {
  std::uint32_t none = kNoSurface;  // all bits
  for (const DepartedSurface& each : std::span(rays_->departed).subspan(begin_, count_))
    none &= each.surface;
  return none != kNoSurface;
}

unsigned LaneBlock::curve_slot(const Surfaces& walls, const DepartedSurface& departed) {
  if (departed.surface == kNoSurface) return lanes::kNone;
  const auto& curves = walls.curve_numbers;
  const auto at = std::lower_bound(curves.begin(), curves.end(), departed.surface);
  const bool is_curve = at != curves.end() && *at == departed.surface;
  return is_curve ? static_cast<unsigned>(at - curves.begin()) : lanes::kNone;
}
unsigned LaneBlock::roots_of(const DepartedSurface& departed) {
  return (departed.root == Root::first || departed.root == Root::both ? 1U : 0U) |
         (departed.root == Root::second || departed.root == Root::both ? 2U : 0U);
}

// The walls that rays have left; whether the lanes cannot tell one of them from others.
bool LaneBlock::find_left(const CellGrid& cells) {
  static_assert(kNoSurface == lanes::kNone);
  bool some_unable = false;
  std::fill(departed_.begin() + static_cast<std::ptrdiff_t>(count_), departed_.end(), lanes::kNone);
  for (std::size_t i = 0; i < count_; ++i) {
    const DepartedSurface& departed = rays_->departed[begin_ + i];
    departed_[i] =
        cells.of_curves() ? curve_slot(walls_, departed) : walls_.segment_slot(departed.surface);
    roots_[i] = roots_of(departed);
    if (departed_[i] == lanes::kNone || !cells.is_ambiguous(departed_[i])) continue;
    fate_[i] = lanes::kDoubt;
    some_unable = true;
  }
  return some_unable;
}

}  // namespace flatray
