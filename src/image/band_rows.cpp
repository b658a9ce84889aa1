#include "image/band_rows.h"

#include <algorithm>

namespace flatray {

int tile_rows(int width) {
  constexpr int kTilePixels = 1 << 15;  // half a megabyte of floats: stays in the second cache
  return std::clamp(kTilePixels / std::max(width, 1), 1, 64);
}

int band_rows(int width) {
  constexpr int kBandPixels = 1 << 17;
  const int rows = tile_rows(width);
  return rows * std::max(kBandPixels / std::max(width, 1) / rows, 1);
}

}  // namespace flatray
