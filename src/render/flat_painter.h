#pragma once
#include <cstdint>
#include <vector>

#include "image/flat_tile.h"
#include "render/frame.h"
#include "render/item_scan.h"

namespace flatray {

/// Draws bands from the uppermost item down: a pixel an opaque item covers is settled, and nothing
/// below it is touched. What covers a pixel in part waits until all are settled and is then
/// blended from the bottom up, by the sums of `SpanKernels::blend_runs`, so that the pixels are
/// those of drawing everything in order.
class FlatPainter {
 public:
  FlatPainter(const DrawList& list, DrawCounts& counts);

  /// Draws the items of a band into the rows of `out` from `y` on. False, and nothing drawn, where
  /// so many items lie over one another in part that blending them in order costs less.
  bool paint(const PixelBox& box, const std::vector<BandItem>& items, int y, Image& out);

 private:
  /// A share of a pixel in the colour of an item.
  struct Fragment {
    std::uint32_t pixel, name, steps;
  };

  void begin(const PixelBox& box);
  void lay(const std::vector<Run>& runs, bool opaque, std::uint32_t name);
  void add_fragment(int row, int x, std::uint32_t name, std::uint32_t steps);
  void settle_background();
  void blend_fragments();
  std::uint32_t add_colour(const LinearColour& colour);
  template <class Take>
  void each_open(int row, int x_begin, int x_end, bool settle, const Take& take);

  const DrawList& list_;
  DrawCounts& counts_;
  ItemScan scan_;
  RunList runs_;
  PixelBox box_;
  FlatTile tile_;
  std::size_t row_words_ = 0, open_ = 0;  ///< pixels not settled
  std::vector<std::uint64_t> settled_;    ///< a bit a pixel, whole words a row
  std::vector<Fragment> fragments_;
};

}  // namespace flatray
