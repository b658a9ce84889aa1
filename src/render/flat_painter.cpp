#include "render/flat_painter.h"

#include <algorithm>
#include <bit>

namespace flatray {
namespace {

constexpr unsigned kWordPixels = 64;
constexpr std::uint64_t kAll = ~std::uint64_t{0};

std::uint64_t from_bit(unsigned x) { return kAll << (x % kWordPixels); }
std::uint64_t to_bit(unsigned x) { return kAll >> (kWordPixels - 1 - x % kWordPixels); }

template <class Take>
void each_bit(std::uint64_t bits, const Take& take) {
  for (; bits != 0; bits &= bits - 1) take(static_cast<unsigned>(std::countr_zero(bits)));
}

// As blend_runs of kernels/portable.cpp.
Light blended(const Light& colour, float share, const Light& below) {
  const float keep = 1.0F - colour[3] * share;
  Light result;
  for (std::size_t i = 0; i < 4; ++i) result[i] = colour[i] * share + below[i] * keep;
  return result;
}

}  // namespace

FlatPainter::FlatPainter(const DrawList& list, bool (*stop)()) : list_(list), scan_(list, stop) {}

std::optional<std::size_t> FlatPainter::paint(const PixelBox& box, const Band& band,
                                              const StillBand* still, int y, Image& out) {
  box_ = box;
  still_ = still;
  lowest_ = still == nullptr ? 0 : still->items();
  channels_ = out.channels;
  pixels_ = static_cast<std::size_t>(box.width) * static_cast<std::size_t>(box.height);
  if (pixels_ == 0) return 0;
  first_ = out.at(0, y);
  const bool whole_pixels = list_.coverage == Coverage::centre && band.opaque_from() <= lowest_;
  return whole_pixels ? write_in_order(band) : settle_from_above(band);
}

std::size_t FlatPainter::write_in_order(const Band& band) {
  const std::size_t hidden = first_seen(band);
  const auto channels = static_cast<std::size_t>(channels_);
  if (still_ == nullptr)
    put_run(shown_colour(premultiplied(list_.background), channels_), channels * pixels_, first_);
  else if (hidden == 0)
    std::copy_n(still_->shown().data(), channels * pixels_, first_);
  for (std::size_t i = std::max(hidden, lowest_); i < band.size(); ++i) {
    runs_.clear();
    scan_.scan(band, band[i], box_, runs_);
    const ShownColour colour = shown_colour(premultiplied(band[i].colour), channels_);
    for (const Run& run : runs_.runs())
      put_run(colour, channels * static_cast<std::size_t>(run.x_end - run.x_begin),
              first_ + channels * pixel(run.y - box_.y, run.x_begin - box_.x));
  }
  return hidden;
}

// The uppermost item that hides all below it, or the first.
std::size_t FlatPainter::first_seen(const Band& band) {
  for (std::size_t i = band.size(); i-- > lowest_;) {
    if (!band[i].may_cover(box_)) continue;
    runs_.clear();
    scan_.scan(band, band[i], box_, runs_);
    if (covers_all(runs_.runs(), box_)) return i;
  }
  return 0;
}

std::optional<std::size_t> FlatPainter::settle_from_above(const Band& band) {
  constexpr std::size_t kMostAPixel = 8;
  begin();
  std::size_t i = band.size();
  while (i > lowest_ && open_ > 0) {
    const BandItem& item = band[--i];
    runs_.clear();
    scan_.scan(band, item, box_, runs_);
    lay(item.colour.a == 1, add_colour(item.colour));
    if (fragment_count_ > kMostAPixel * pixels_) return std::nullopt;
  }
  shared_ = static_cast<std::uint32_t>(colours_.size());
  blended_.clear();
  if (still_ == nullptr)
    settle_background();
  else
    settle_still();
  blend_fragments();
  return open_ == 0 ? i : 0;
}

void FlatPainter::begin() {
  open_ = pixels_;
  row_words_ =
      static_cast<std::size_t>((static_cast<unsigned>(box_.width) + kWordPixels - 1) / kWordPixels);
  words_.assign(row_words_ * static_cast<std::size_t>(box_.height), {});
  if (names_room_ < pixels_) {
    names_ = std::make_unique_for_overwrite<std::uint32_t[]>(pixels_);
    names_room_ = pixels_;
  }
  fragment_count_ = 0;
  colours_.clear();
  add_colour(list_.background);
  if (still_ != nullptr)
    std::copy_n(still_->shown().data(), static_cast<std::size_t>(channels_) * pixels_, first_);
}

std::uint32_t FlatPainter::add_colour(const LinearColour& c) {
  colours_.push_back(premultiplied(c));
  return static_cast<std::uint32_t>(colours_.size() - 1);
}

// Fragments without a branch: whether a pixel is settled is a matter of luck.
void FlatPainter::lay(bool opaque, std::uint32_t name) {
  const ShownColour colour = shown_colour(colours_[name], channels_);
  std::size_t count = fragment_count_;
  for (const Run& run : runs_.runs()) {
    const int row = run.y - box_.y, begin = run.x_begin - box_.x, end = run.x_end - box_.x;
    if (opaque && run.steps == kFullCoverage) {
      settle(row, begin, end, name, colour);
      continue;
    }
    const std::size_t most = count + static_cast<std::size_t>(end - begin);
    if (fragments_.size() < most) fragments_.resize(2 * most);
    Word* const of_row = words(row);
    std::uint32_t at = pixel(row, begin);
    for (auto x = static_cast<unsigned>(begin); x < static_cast<unsigned>(end); ++x, ++at) {
      Word& word = of_row[x / kWordPixels];
      const std::uint64_t open = ~(word.settled >> (x % kWordPixels)) & 1;
      word.in_part |= open << (x % kWordPixels);
      fragments_[count] = {at, name, run.steps};
      count += open;
    }
  }
  fragment_count_ = count;
}

// Neighbouring open pixels are written together, across words too: `from` is where those began that
// reach the end of the word before.
void FlatPainter::settle(int row, int x_begin, int x_end, std::uint32_t name,
                         const ShownColour& colour) {
  constexpr unsigned kNone = ~0U;
  Word* const of_row = words(row);
  const auto channels = static_cast<std::size_t>(channels_);
  const std::uint32_t first_pixel = pixel(row, 0);
  std::uint8_t* const out = first_ + channels * first_pixel;
  const auto put = [&](unsigned begin, unsigned end) {
    put_run(colour, channels * (end - begin), out + channels * begin);
    open_ -= end - begin;
  };
  const auto begin = static_cast<unsigned>(x_begin), end = static_cast<unsigned>(x_end);
  const unsigned last = (end - 1) / kWordPixels;
  std::uint64_t asked = from_bit(begin);
  unsigned from = kNone;
  for (unsigned index = begin / kWordPixels; index <= last; ++index, asked = kAll) {
    if (index == last) asked &= to_bit(end - 1);
    Word& word = of_row[index];
    std::uint64_t open = asked & ~word.settled;
    word.settled |= asked;
    const unsigned base = index * kWordPixels;
    if ((open & word.in_part) != 0)
      each_bit(open & word.in_part, [&](unsigned bit) { names_[first_pixel + base + bit] = name; });
    if (from != kNone) {
      if (open == kAll && index < last) continue;
      const auto length = static_cast<unsigned>(std::countr_one(open));
      put(from, base + length);
      from = kNone;
      open = length < kWordPixels ? open & from_bit(length) : 0;
    }
    while (open != 0) {
      const auto bit = static_cast<unsigned>(std::countr_zero(open));
      const unsigned stop = bit + static_cast<unsigned>(std::countr_one(open >> bit));
      if (stop == kWordPixels && index < last) {
        from = base + bit;
        break;
      }
      put(base + bit, base + stop);
      if (stop == kWordPixels) break;
      open &= from_bit(stop);
    }
  }
}

void FlatPainter::settle_background() {
  if (open_ == 0) return;
  const std::size_t open = open_;
  const ShownColour colour = shown_colour(colours_[0], channels_);
  for (int row = 0; row < box_.height; ++row) settle(row, 0, box_.width, 0, colour);
  open_ = open;
}

// What is open shows the still items already: `begin` wrote them. Where more lies over that in part
// their light is what it is laid on.
void FlatPainter::settle_still() {
  for (int row = 0; row < box_.height; ++row)
    for (std::size_t i = 0; i < row_words_; ++i) {
      const Word& word = words(row)[i];
      const std::uint32_t first = pixel(row, 0) + kWordPixels * static_cast<std::uint32_t>(i);
      each_bit(word.in_part & ~word.settled, [&](unsigned bit) {
        names_[first + bit] = static_cast<std::uint32_t>(colours_.size());
        colours_.push_back(still_->light(first + bit));
        blended_.push_back(first + bit);
      });
    }
}

// The last of a pixel's fragments lies lowest. With the first, the pixel gets a colour of its own.
void FlatPainter::blend_fragments() {
  for (std::size_t i = fragment_count_; i-- > 0;) {
    const Fragment* const it = &fragments_[i];
    std::uint32_t& name = names_[it->pixel];
    const Light mixed = blended(colours_[it->name], coverage_share(it->steps), colours_[name]);
    if (name >= shared_) {
      colours_[name] = mixed;
    } else {
      name = static_cast<std::uint32_t>(colours_.size());
      colours_.push_back(mixed);
      blended_.push_back(it->pixel);
    }
  }
  put_pixels(std::span(colours_).subspan(shared_), blended_, channels_, first_);
}

}  // namespace flatray
