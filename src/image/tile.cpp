#include "image/tile.h"

#include <algorithm>
#include <cstring>

#include "base/check.h"
#include "image/develop_pixel.h"

namespace flatray {
namespace {

bool same_bits(const float* a, const float* b) {
  std::uint64_t x[2], y[2];
  std::memcpy(x, a, sizeof x);
  std::memcpy(y, b, sizeof y);
  return ((x[0] ^ y[0]) | (x[1] ^ y[1])) == 0;
}

// Most pixels repeat their left neighbour: compared, not developed again.
template <class Kind>
void develop_row(const float* rgba, int count, const SrgbEncoder& encode, std::uint8_t* out) {
  constexpr int kChannels = Kind::kChannels;
  Kind::pixel(rgba, encode, out);
  for (int i = 1; i < count; ++i) {
    rgba += 4, out += kChannels;
    if (same_bits(rgba, rgba - 4))
      std::memcpy(out, out - kChannels, kChannels);
    else
      Kind::pixel(rgba, encode, out);
  }
}

template <class Kind>
void develop_rows(const Tile& tile, Image& out) {
  const SrgbEncoder& encode = SrgbEncoder::get();
  for (int y = 0; y < tile.height; ++y)
    develop_row<Kind>(tile.row(y), tile.width, encode, out.at(tile.x, tile.y + y));
}

void check_inside(const Tile& tile, int width, int height) {
  FLATRAY_CHECK(tile.x >= 0 && tile.y >= 0 && tile.width >= 0 && tile.height >= 0);
  FLATRAY_CHECK(tile.width <= width - tile.x && tile.height <= height - tile.y);
}

}  // namespace

int tile_rows(int width) {
  constexpr int kTilePixels = 1 << 15;  // half a megabyte of floats: stays in the second cache
  return std::clamp(kTilePixels / std::max(width, 1), 1, 64);
}

int band_rows(int width) {
  constexpr int kBandPixels = 1 << 17;
  const int rows = tile_rows(width);
  return rows * std::max(kBandPixels / std::max(width, 1) / rows, 1);
}

void develop(const Tile& tile, Image& out) {
  check_inside(tile, out.width, out.height);
  if (tile.width == 0) return;
  if (out.channels == 3)
    develop_rows<Opaque>(tile, out);
  else
    develop_rows<Straight>(tile, out);
}

void develop(const Tile& tile, LinearImage& out) {
  check_inside(tile, out.width, out.height);
  for (int y = 0; y < tile.height; ++y) {
    const float* from = tile.row(y);
    const auto row = static_cast<std::size_t>(tile.y + y) * static_cast<std::size_t>(out.width);
    float* to = out.pixels.data() + 3 * (row + static_cast<std::size_t>(tile.x));
    for (int x = 0; x < tile.width; ++x, from += 4, to += 3) std::copy_n(from, 3, to);
  }
}

}  // namespace flatray
