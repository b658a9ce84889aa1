#pragma once
#include "geom/bounds.h"

namespace flatray {

/// Rectangle of pixels, rows top-down; pixel (i, j) is [i, i+1] x [j, j+1] of the film.
struct PixelBox {
  int x = 0, y = 0, width = 0, height = 0;

  int right() const { return x + width; }
  int bottom() const { return y + height; }
};

}  // namespace flatray
