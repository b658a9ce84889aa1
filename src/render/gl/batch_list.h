#pragma once
#include <array>
#include <span>

#include "render/draw_list.h"
#include "render/gl/batches.h"
#include "render/gl/grid.h"

namespace flatray::gl {

/// Pixels [x0, x1) x [y0, y1) of a tile.
struct CellBox {
  int x0, y0, x1, y1;
  bool empty() const { return x0 >= x1 || y0 >= y1; }
  /// The smallest box around both.
  void add(const CellBox& more);
};

/// What a vertex has besides its place: FlatrayGlVertex::paint.
struct VertexPaint {
  std::array<float, 4> words;
  bool gradient = false;
};

/// Puts items into few batches. Items wait in a group as long as none of those with marks shares a
/// place with another one, and all have gradients or none: then their order does not matter. Layers
/// wait as long as nothing comes that lies where they do, and are drawn on one sheet.
class BatchList {
 public:
  BatchList(int width, int height) : width_(width), height_(height) {}

  /// Pixels a figure can touch, with a pixel around it for the shifts of its samples.
  CellBox box(std::span<const GridPoint> points) const;

  /// A convex figure that is blended as it is.
  void paint(std::span<const GridPoint> corners, const VertexPaint& paint, const CellBox& box);

  /// An item that is marked first and then covered: triangles from the first point of each figure
  /// to every edge of it, as marks of `kind`.
  void mark(FlatrayGlKind kind, std::span<const std::vector<GridPoint>> figures,
            const VertexPaint& paint, const CellBox& box);

  /// What another list drew of the tile, as one picture, faded.
  void lay(BatchList&& layer, float opacity);

  Batches finish() &&;

 private:
  // Cells of 32 x 32 pixels in which something of the group lies.
  class Occupied {
   public:
    bool any(const CellBox& box) const;
    void add(const CellBox& box);
    void clear() { rows_ = {}; }

   private:
    static constexpr int kCell = 5, kCells = FLATRAY_GL_TILE >> kCell;
    static_assert(kCells == 64, "a row of cells is a word");
    static std::uint64_t columns(const CellBox& box);
    std::array<std::uint64_t, kCells> rows_{};
  };
  static constexpr int kBeyond = FLATRAY_GL_TILE;

  void flush();
  void push(int kind);
  void begin_item(const VertexPaint& paint, const Occupied& others, const CellBox& box);
  static void add_fan(std::span<const GridPoint> corners, const VertexPaint& paint,
                      std::vector<FlatrayGlVertex>& to);
  static void add_box(const CellBox& box, const VertexPaint& paint,
                      std::vector<FlatrayGlVertex>& to);

  int width_, height_;
  std::array<std::vector<FlatrayGlVertex>, FLATRAY_GL_LAY + 1> waiting_;  // by kind
  Batches layers_;  // that wait, none where another is
  Occupied marked_, any_, layered_;
  bool gradients_ = false;                 // of the group
  CellBox reach_{kBeyond, kBeyond, 0, 0};  // of all there is
  Batches all_;
};

}  // namespace flatray::gl
