#include "render/flat_painter.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace flatray {
namespace {

constexpr int kWordPixels = 64;

using Light = std::array<float, 4>;

// As blend_runs of kernels/portable.cpp.
Light blended(const Light& colour, float share, const Light& below) {
  const float keep = 1.0F - colour[3] * share;
  Light result;
  for (std::size_t i = 0; i < 4; ++i) result[i] = colour[i] * share + below[i] * keep;
  return result;
}

// The compiler does not widen this at -O2.
void fill(std::uint32_t* names, std::size_t count, std::uint32_t name) {
  typedef std::uint32_t Four __attribute__((vector_size(16)));
  const Four four = {name, name, name, name};
  for (; count >= 4; count -= 4, names += 4) std::memcpy(names, &four, sizeof four);
  for (; count > 0; --count) *names++ = name;
}

}  // namespace

FlatPainter::FlatPainter(const DrawList& list, DrawCounts& counts)
    : list_(list), counts_(counts), scan_(list) {}

bool FlatPainter::paint(const PixelBox& box, const std::vector<BandItem>& items, int y,
                        Image& out) {
  constexpr std::size_t kMostAPixel = 8;
  begin(box);
  const std::size_t most = kMostAPixel * open_;
  std::size_t hidden = 0;
  for (std::size_t i = items.size(); i-- > 0;) {
    const LinearColour& colour = list_.items[items[i].item].colour;
    runs_.clear();
    scan_.scan(items[i], box, runs_);
    lay(runs_.runs(), colour.a == 1, add_colour(colour));
    if (fragments_.size() > most) return false;
    if (open_ > 0) continue;
    hidden = i;
    break;
  }
  ++counts_.bands;
  counts_.items += items.size();
  counts_.hidden_items += hidden;
  settle_background();
  blend_fragments();
  tile_.y = y;
  develop(tile_, out);
  return true;
}

void FlatPainter::begin(const PixelBox& box) {
  box_ = box;
  tile_.width = box.width;
  tile_.height = box.height;
  open_ = static_cast<std::size_t>(box.width) * static_cast<std::size_t>(box.height);
  tile_.names.resize(open_);
  tile_.colours.clear();
  add_colour(list_.background);
  row_words_ = static_cast<std::size_t>((box.width + kWordPixels - 1) / kWordPixels);
  settled_.assign(row_words_ * static_cast<std::size_t>(box.height), 0);
  fragments_.clear();
}

std::uint32_t FlatPainter::add_colour(const LinearColour& c) {
  tile_.colours.push_back(premultiplied(c));
  return static_cast<std::uint32_t>(tile_.colours.size() - 1);
}

// Calls `take` with the index and the number of neighbouring open pixels, in pieces of a word at
// most.
template <class Take>
void FlatPainter::each_open(int row, int x_begin, int x_end, bool settle, const Take& take) {
  const auto pixel = static_cast<std::uint32_t>(row) * static_cast<std::uint32_t>(box_.width);
  std::uint64_t* words = settled_.data() + static_cast<std::size_t>(row) * row_words_;
  for (int x = x_begin; x < x_end;) {
    const int in_word = x % kWordPixels;
    const int count = std::min(x_end - x, kWordPixels - in_word);
    const std::uint64_t asked = (~std::uint64_t{0} >> (kWordPixels - count)) << in_word;
    std::uint64_t& word = words[x / kWordPixels];
    std::uint64_t open = asked & ~word;
    if (settle) word |= asked;
    const auto base = pixel + static_cast<std::uint32_t>(x - in_word);
    while (open != 0) {
      const int from = std::countr_zero(open), length = std::countr_one(open >> from);
      take(base + static_cast<std::uint32_t>(from), static_cast<std::size_t>(length));
      if (from + length == kWordPixels) break;
      open &= ~std::uint64_t{0} << (from + length);
    }
    x += count;
  }
}

void FlatPainter::lay(const std::vector<Run>& runs, bool opaque, std::uint32_t name) {
  for (const Run& run : runs) {
    const int row = run.y - box_.y, begin = run.x_begin - box_.x, end = run.x_end - box_.x;
    if (opaque && run.steps == kFullCoverage)
      each_open(row, begin, end, true, [&](std::uint32_t pixel, std::size_t count) {
        fill(tile_.names.data() + pixel, count, name);
        open_ -= count;
      });
    else if (end - begin == 1)
      add_fragment(row, begin, name, run.steps);
    else
      each_open(row, begin, end, false, [&](std::uint32_t pixel, std::size_t count) {
        for (std::uint32_t i = 0; i < count; ++i)
          fragments_.push_back({pixel + i, name, run.steps});
      });
  }
}

void FlatPainter::add_fragment(int row, int x, std::uint32_t name, std::uint32_t steps) {
  const std::uint64_t word =
      settled_[static_cast<std::size_t>(row) * row_words_ + static_cast<unsigned>(x) / kWordPixels];
  if ((word >> (x % kWordPixels) & 1) != 0) return;
  fragments_.push_back({static_cast<std::uint32_t>(row * box_.width + x), name, steps});
}

void FlatPainter::settle_background() {
  if (open_ == 0) return;
  for (int row = 0; row < box_.height; ++row)
    each_open(row, 0, box_.width, false, [&](std::uint32_t pixel, std::size_t count) {
      fill(tile_.names.data() + pixel, count, 0);
    });
}

// The last of a pixel's fragments lies lowest. With the first, the pixel gets a colour of its own.
void FlatPainter::blend_fragments() {
  std::vector<Light>& colours = tile_.colours;
  const auto shared = static_cast<std::uint32_t>(colours.size());
  for (auto it = fragments_.rbegin(); it != fragments_.rend(); ++it) {
    std::uint32_t& name = tile_.names[it->pixel];
    const Light mixed = blended(colours[it->name], coverage_share(it->steps), colours[name]);
    if (name >= shared) {
      colours[name] = mixed;
    } else {
      name = static_cast<std::uint32_t>(colours.size());
      colours.push_back(mixed);
    }
  }
}

}  // namespace flatray
