#pragma once
#include <vector>

#include "image/tile.h"
#include "render/item_scan.h"
#include "render/layer.h"
#include "render/still_layer.h"

namespace flatray {

/// Draws bands of any items as light, one after another; its room is kept from one to the next.
class BandPainter {
 public:
  /// `hide`: what an opaque item covers is not drawn.
  BandPainter(const DrawList& list, bool hide);

  /// The lowest `items` of a band, over `still` where there is one; at (0, y) of a picture.
  const Tile& paint(const PixelBox& box, const Band& band, std::size_t items,
                    const StillBand* still, int y);
  /// Items the last call left out, as one above hides them.
  std::size_t hidden() const { return hidden_; }

 private:
  struct Scanned {
    const DrawItem* item;
    std::size_t begin, end;  ///< of its runs
  };

  bool scan(const PixelBox& box, const Band& band, std::size_t first, std::size_t last);
  void blend_all(const kernels::Target& target, int rows);
  void blend(const Scanned& scanned, const kernels::Target& target);

  const DrawList& list_;
  const bool hide_;
  std::size_t hidden_ = 0;
  const kernels::SpanKernels& kernels_;
  Tile tile_;
  ItemScan item_scan_;
  RunList runs_;
  std::vector<Scanned> scanned_;
  Layer layer_;
};

}  // namespace flatray
