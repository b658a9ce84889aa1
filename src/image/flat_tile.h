#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "image/image.h"

namespace flatray {

/// Rectangle of the film whose pixels name their colours: most share one, and each is developed
/// once.
struct FlatTile {
  int x = 0, y = 0, width = 0, height = 0;
  std::vector<std::uint32_t> names;                ///< width * height, each an index into `colours`
  std::vector<std::array<float, 4>> colours;       ///< linear premultiplied RGBA
  std::vector<std::array<std::uint8_t, 4>> shown;  ///< room for the developed ones
};

/// Develops a tile into its place of a picture, as a `Tile` with these colours would be.
void develop(FlatTile& tile, Image& out);

}  // namespace flatray
