#include "trace/lane_block.h"

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

LaneBlock::LaneBlock(const Surfaces& walls, const CellGrid& cells, const lanes::Grid& grid,
                     const lanes::WalkKernels& kernels, std::size_t most)
    : walls_(walls),
      cells_(cells),
      grid_(grid),
      kernels_(kernels),
      room_(RayBlock::whole_vectors(most) + kVector),
      numbers_(room_),
      columns_(kColumns * room_),
      departed_(room_),
      fate_(room_),
      found_(room_),
      open_(room_) {
  std::iota(numbers_.begin(), numbers_.end(), 0.0F);
}

void LaneBlock::load(const RayBatch& rays, std::size_t begin, std::size_t count) {
  rays_ = &rays;
  begin_ = begin;
  count_ = count;
  given_ = whole_.take(rays, begin, count);
}

std::span<const int> LaneBlock::walk(std::span<const double> up_to) {
  lanes::Walking w = columns_of(columns_.data(), numbers_.data(), room_);
  w.count = static_cast<int>(count_);
  if (!up_to.empty()) {
    ends_.assign(room_, 0);
    std::copy_n(up_to.begin() + static_cast<std::ptrdiff_t>(begin_), count_, ends_.begin());
    w.up_to = ends_.data();
  }
  bool some_unable = false;
  if (some_have_left()) {
    some_unable = find_left();
    w.departed = departed_.data();
  }
  some_unable = kernels_.prepare(grid_, given_, w, fate_.data()) || some_unable;
  (grid_.cells != nullptr ? kernels_.walk : kernels_.scan)(grid_, w, found_.data());
  for (std::size_t i = 0; some_unable && i < room_; ++i)
    if (std::exchange(fate_[i], 0) != 0) found_[i] = lanes::kDoubt;
  return {found_.data(), count_};
}

std::span<const int> LaneBlock::finish(NearestHit* hits) {
  const int open =
      kernels_.finish(grid_, given_,
                      {found_.data(), static_cast<int>(count_), hits, word_of(0, HitClass::touch),
                       word_of(kNoSurface, HitClass::miss), open_.data()});
  return {open_.data(), static_cast<std::size_t>(open)};
}

bool LaneBlock::some_have_left() const {
  std::uint32_t none = kNoSurface;  // all bits
  for (const DepartedSurface& each : std::span(rays_->departed).subspan(begin_, count_))
    none &= each.surface;
  return none != kNoSurface;
}

// The segments that rays have left; whether the lanes cannot tell one of them from others.
bool LaneBlock::find_left() {
  static_assert(kNoSurface == lanes::kNone);
  bool some_unable = false;
  std::fill(departed_.begin() + static_cast<std::ptrdiff_t>(count_), departed_.end(), lanes::kNone);
  for (std::size_t i = 0; i < count_; ++i) {
    departed_[i] = walls_.segment_slot(rays_->departed[begin_ + i].surface);
    if (departed_[i] == lanes::kNone || !cells_.is_ambiguous(departed_[i])) continue;
    fate_[i] = lanes::kDoubt;
    some_unable = true;
  }
  return some_unable;
}

}  // namespace flatray
