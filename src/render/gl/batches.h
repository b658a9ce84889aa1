#pragma once
#include <vector>

#include "render/draw_list.h"
#include "render/gl/module.h"
#include "render/pixel_box.h"

namespace flatray::gl {

/// What the module draws of a draw list in one tile.
struct Batches {
  std::vector<FlatrayGlVertex> vertices;
  std::vector<FlatrayGlBatch> batches;
  std::vector<FlatrayGlGradient> gradients;
  std::vector<FlatrayGlStop> stops;
};

/// Triangles for the items of `list` in `tile`, corners on the grid (grid.h).
///
/// Needs   a tile of at most FLATRAY_GL_TILE pixels each way.
/// Gives   items in their order: convex regions that follow one another in one batch; of other
///         regions first their marks, then their light. Curves as chords within 1/256 of a pixel.
/// Cost    O(edges), O(edges log edges) for those not in the order of their rings.
Batches batches(const DrawList& list, const PixelBox& tile);

}  // namespace flatray::gl
