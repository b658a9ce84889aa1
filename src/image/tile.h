#pragma once
#include <vector>

#include "image/image.h"

namespace flatray {

/// Rows of the bands a picture is drawn and packed in. By its width alone, so that the bytes do not
/// depend on threads; narrower than 512 pixels, more rows than are drawn at once.
/// Gives   a multiple of `tile_rows`, some 128 K pixels where that allows.
int tile_rows(int width);
int band_rows(int width);

/// Rectangle of the film in linear premultiplied RGBA, 4 floats a pixel, small enough to stay in
/// cache.
struct Tile {
  int x = 0, y = 0, width = 0, height = 0;
  std::vector<float> rgba;

  float* row(int y_in_tile) {
    return rgba.data() + 4 * static_cast<std::size_t>(y_in_tile) * static_cast<std::size_t>(width);
  }
  const float* row(int y_in_tile) const {
    return rgba.data() + 4 * static_cast<std::size_t>(y_in_tile) * static_cast<std::size_t>(width);
  }
};

/// Develops a tile into its place of an 8-bit picture (3 channels: over opaque background; 4:
/// straight alpha).
void develop(const Tile& tile, Image& out);
/// Copies a tile's light into its place of a linear picture.
void develop(const Tile& tile, LinearImage& out);

}  // namespace flatray
