// What BandScan draws of pixels when all is known that shows in them.
#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <utility>

#include "render/coverage/band_scan.h"

namespace flatray {
namespace {

Light mixed(const Light& a, const Light& b, double share) {
  Light mean;
  for (std::size_t c = 0; c < 4; ++c)
    mean[c] = static_cast<float>(share * static_cast<double>(a[c]) +
                                 (1 - share) * static_cast<double>(b[c]));
  return mean;
}

// Of a pixel that an item covers in part: the share of the item, which is simple or has one edge
// there that parts two winding numbers.
double share_of(const ItemLook& look, int winding, std::span<const Piece> pieces) {
  double wound = 0;
  for (const Piece& piece : pieces) wound += area_right_of(piece);
  if (look.simple) return std::min(std::abs(winding + wound), 1.0);
  const bool here = look.covers(winding), there = look.covers(winding + (wound > 0 ? 1 : -1));
  const double other = std::min(std::abs(wound), 1.0);
  return here == there ? (here ? 1 : 0) : here ? 1 - other : other;
}

}  // namespace

// What shines in a row, and the background with the parts above it.
void BandScan::draw_row(int row) {
  begin_row(row);
  std::vector<Cover>& covers = *row_covers_;
  std::sort(covers.begin(), covers.end());
  int from = box_.x;
  for (const Cover& cover : covers) {
    draw_shining(std::exchange(from, cover.column), cover.column);
    const auto at =
        std::lower_bound(active_.begin(), active_.end(), cover,
                         [](const Cover& a, const Cover& b) { return a.item < b.item; });
    if (cover.begins)
      active_.insert(at, cover);
    else
      active_.erase(at);
  }
  draw_shining(from, box_.right());
  covers.clear(), active_.clear();
  const auto rest = [this](std::size_t i) {
    const Words& words = row_words_[i];
    const std::uint64_t open = ~(words.settled | words.shines);
    each_one(i, open & words.waits, [&](int at) { draw_part(at, nullptr); });
    return open & ~words.waits;
  };
  each_run(0, stride_ - 1, rest,
           [&](int b, int e) { sink_->run(row, box_.x + b, box_.x + e, background_); });
}

// Pixels that the same items cover, some of them with parts of others.
void BandScan::draw_shining(int begin, int end) {
  if (begin >= end || active_.empty()) return;
  const std::size_t first = place(begin), last = place(end);
  const auto pixels = [&](std::size_t i) {
    const std::uint64_t bits = bits_within(i, first, last), waits = row_words_[i].waits;
    each_one(i, bits & waits, [&](int at) {
      const int column = box_.x + at;
      const std::uint32_t part = row_lowest_[static_cast<std::size_t>(at)];
      sink_->pixel(row_, column, joint_light(column, part, nullptr));
    });
    return bits & ~waits;
  };
  each_run(first / 64, (last - 1) / 64, pixels,
           [&](int b, int e) { draw_run(box_.x + b, box_.x + e); });
}

void BandScan::draw_run(int begin, int end) {
  const Light light = joint_light(begin, kNone, nullptr);
  if (!varies_) return sink_->run(row_, begin, end, light);
  sink_->pixel(row_, begin, light);
  for (int x = begin + 1; x < end; ++x) sink_->pixel(row_, x, joint_light(x, kNone, nullptr));
}

// A pixel that is seen whole below its parts.
void BandScan::draw_part(int at, const ItemLook* below) {
  const std::uint32_t lowest = row_lowest_[static_cast<std::size_t>(at)];
  const Part& part = parts_[lowest];
  const ItemLook& look = looks_[part.item];
  const bool one = part.above == kNone && look.opaque && !look.varies &&
                   (rays_ > 0 || look.simple || part.count == 1);
  const int column = box_.x + at;
  sink_->pixel(row_, column,
               one ? light_of(part, below == nullptr ? background_ : below->light)
                   : joint_light(column, lowest, below));
}

// Of one part of an opaque item of one colour, which most pixels show.
Light BandScan::light_of(const Part& part, const Light& below) const {
  const ItemLook& look = looks_[part.item];
  const std::span<const Piece> pieces(pieces_.data() + part.first, part.count);
  if (rays_ == 0) return mixed(look.light, below, share_of(look, part.wound.winding, pieces));
  SummedLight sum;
  auto next = pieces.begin();
  for (int ray = 0; ray < rays_; ++ray) {
    int winding = (part.wound.rays >> ray & 1) != 0 ? part.wound.winding : 0;
    double from = 0;
    for (; next != pieces.end() && next->ray == ray; ++next) {
      sum.add(next->x_top - from, look.covers(winding) ? look.light : below);
      from = next->x_top;
      winding += next->direction;
    }
    sum.add(1 - from, look.covers(winding) ? look.light : below);
  }
  return sum.over(rays_);
}

Light BandScan::joint_light(int column, std::uint32_t part, const ItemLook* below) {
  see(column, part, below);
  if (shown_.empty()) return seen_.composed();
  if (rays_ > 0) return mean_of_rays();
  if (shown_.size() == 1 &&
      (seen_.items[shown_[0].seen].look->simple || shown_[0].part->count == 1))
    return part_covered(shown_[0]);
  if (const auto light = light_of_rest()) return *light;
  pieces_of_.clear();
  for (auto one = shown_.rbegin(); one != shown_.rend(); ++one)
    for (std::uint32_t i = 0; i < one->part->count; ++i)
      pieces_of_.emplace_back(pieces_[one->part->first + i], one->seen);
  return area_.mean(pieces_of_, seen_, row_);
}

// What may be seen in a pixel, from the lowest item up.
void BandScan::see(int column, std::uint32_t part, const ItemLook* below) {
  shown_.clear();
  seen_.begin(below == nullptr ? background_ : below->light);
  varies_ = false;
  const auto light_of = [&](const ItemLook& look) {
    varies_ |= look.varies;
    return look.varies ? look.at(column, row_, list_.width) : look.light;
  };
  auto cover = active_.begin();
  while (cover != active_.end() || part != kNone) {
    const bool is_cover =
        part == kNone || (cover != active_.end() && cover->item < parts_[part].item);
    if (is_cover) {
      const ItemLook& look = looks_[cover->item];
      const bool all = cover->rays == all_rays_;
      if (all && look.opaque) shown_.clear();
      if (all)
        seen_.add_whole(look, light_of(look));
      else
        shown_.push_back({seen_.add_part(look, light_of(look), 0), nullptr, cover->rays});
      ++cover;
    } else {
      const Part& one = parts_[part];
      const ItemLook& look = looks_[one.item];
      const bool every = one.wound.rays == all_rays_;
      shown_.push_back({seen_.add_part(look, light_of(look), every ? one.wound.winding : 0), &one,
                        every ? 0 : one.wound.rays});
      part = one.above;
    }
  }
  seen_.place_all();
}

Light BandScan::part_covered(const Shown& one) {
  const Part& part = *one.part;
  const double share = share_of(*seen_.items[one.seen].look, part.wound.winding,
                                std::span(pieces_).subspan(part.first, part.count));
  seen_.set(one.seen, true);
  const Light with = seen_.composed();
  seen_.set(one.seen, false);
  return mixed(with, seen_.composed(), share);
}

// Of opaque items, each of them on one side of a few straight edges.
std::optional<Light> BandScan::light_of_rest() {
  if (seen_.items.size() != shown_.size()) return {};
  std::size_t pieces = 0;
  for (const Seen& one : seen_.items)
    if (!one.look->opaque) return {};
  for (const Shown& one : shown_) pieces += one.part->count;
  if (pieces > PixelRest::kMostPieces) return {};
  SummedLight sum;
  rest_.begin();
  for (auto one = shown_.rbegin(); one != shown_.rend(); ++one) {
    const Part& part = *one->part;
    const ItemLook& look = *seen_.items[one->seen].look;
    const std::span<const Piece> of(pieces_.data() + part.first, part.count);
    int sign = 0;  // of the winding numbers inside
    if (part.count == 1) {
      const int direction = of[0].direction,
                left = part.wound.winding - (of[0].left_top ? direction : 0);
      const bool in_left = look.covers(left), in_right = look.covers(left + direction);
      if (in_left == in_right) return {};
      sign = in_right ? direction : -direction;
    } else if (look.simple) {
      double wound = part.wound.winding;
      for (const Piece& piece : of) wound += area_right_of(piece);
      sign = wound > 0 ? 1 : -1;
    } else {
      return {};
    }
    if (!PixelRest::can_cut(of, sign)) return {};
    const std::optional<double> area = rest_.cut(of, sign);
    if (!area) return {};
    sum.add(*area, seen_.items[one->seen].light);
  }
  sum.add(rest_.area(), seen_.ground);
  return sum.over(1);
}

// Along each ray from piece to piece. What begins at the pixel's left border goes on from ray to ray.
Light BandScan::mean_of_rays() {
  constexpr double kBorder = -1;  // before all pieces
  changes_.clear();
  for (const Shown& one : shown_) {
    const int winding = one.part == nullptr ? 1 : one.part->wound.winding;
    for (std::uint64_t turns = (one.rays ^ one.rays << 1) & all_rays_; turns != 0;
         turns &= turns - 1) {
      const int ray = std::countr_zero(turns);
      const bool begins = (one.rays >> ray & 1) != 0;
      changes_.push_back({ray, kBorder, one.seen, begins ? winding : -winding});
    }
    for (std::uint32_t i = 0; one.part != nullptr && i < one.part->count; ++i) {
      const Piece& piece = pieces_[one.part->first + i];
      changes_.push_back({piece.ray, piece.x_top, one.seen, piece.direction});
    }
  }
  std::sort(changes_.begin(), changes_.end(), [](const RayChange& a, const RayChange& b) {
    return a.ray != b.ray ? a.ray < b.ray : a.x < b.x;
  });
  SummedLight sum;
  std::optional<Light> whole;
  auto next = changes_.begin();
  const auto is_of = [&](int ray) { return next != changes_.end() && next->ray == ray; };
  for (int ray = 0; ray < rays_; ++ray) {
    for (; is_of(ray) && next->x == kBorder; ++next) {
      seen_.change(next->seen, next->direction);
      whole.reset();
    }
    const auto first = next;
    double from = 0;
    for (; is_of(ray); ++next) {
      if (next->x > from) sum.add(next->x - from, seen_.composed());
      from = next->x;
      seen_.change(next->seen, next->direction);
    }
    if (first != next) {
      sum.add(1 - from, seen_.composed());
      for (auto one = first; one != next; ++one) seen_.change(one->seen, -one->direction);
    } else {
      if (!whole) whole = seen_.composed();
      sum.add(1, *whole);
    }
  }
  return sum.over(rays_);
}

}  // namespace flatray
