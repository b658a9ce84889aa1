#pragma once
#include <array>
#include <span>

#include "render/draw_list.h"
#include "render/gl/batches.h"
#include "render/gl/grid.h"

namespace flatray::gl {

/// Pixels [x0, x1) x [y0, y1) of a tile; at first none.
struct CellBox {
  int x0 = FLATRAY_GL_TILE, y0 = FLATRAY_GL_TILE, x1 = 0, y1 = 0;
  bool empty() const { return x0 >= x1 || y0 >= y1; }
  /// The smallest box around both.
  void add(const CellBox& more);
};

/// What a vertex has besides its place: FlatrayGlVertex::paint.
struct VertexPaint {
  std::array<float, 4> words;
  bool gradient = false;
};

/// Makes batches of items, in their order: figures that are painted one after another share one.
class BatchList {
 public:
  BatchList(int width, int height) : width_(width), height_(height) {}

  /// A convex figure that is blended as it is.
  void paint(std::span<const GridPoint> corners, const VertexPaint& paint);

  /// An item that is marked first and then covered: triangles from the first point of each figure
  /// to every edge of it, as marks of `kind`.
  void mark(FlatrayGlKind kind, std::span<const std::vector<GridPoint>> figures,
            const VertexPaint& paint);

  /// What another list drew of the tile, as one picture, faded.
  void lay(const BatchList& layer, float opacity);

  Batches finish() && { return std::move(all_); }

 private:
  CellBox box(std::span<const GridPoint> points) const;
  void begin(FlatrayGlKind kind, const VertexPaint& paint);
  void add_fan(std::span<const GridPoint> corners, const VertexPaint& paint);
  void add_box(FlatrayGlKind kind, const CellBox& box, const VertexPaint& paint);

  int width_, height_;
  CellBox reach_;  // of all there is
  Batches all_;
};

}  // namespace flatray::gl
