#pragma once
#include <optional>

#include "image/tile.h"
#include "render/item_scan.h"
#include "render/layer.h"
#include "render/still_layer.h"

namespace flatray {

/// Draws bands of any items as light, one after another; its room is kept from one to the next.
class BandPainter {
 public:
  /// `hide`: what an opaque item covers is not drawn.
  /// `stop`: FrameOptions::stop; what is painted when it says so is no picture.
  BandPainter(const DrawList& list, bool hide, bool (*stop)());

  /// The lowest `items` of a band, over `still` where there is one; at (0, y) of a picture.
  const Tile& paint(const PixelBox& box, const Band& band, std::size_t items,
                    const StillBand* still, int y);
  /// Items the last call left out, as one above hides them.
  std::size_t hidden() const { return hidden_; }
  std::uint64_t scans() const { return item_scan_.scans(); }

 private:
  std::optional<std::size_t> hiding_item(const PixelBox& box, const Band& band, std::size_t first,
                                         std::size_t last);
  void scan(const PixelBox& box, const Band& band, std::size_t i);
  void blend_all(const PixelBox& box, const Band& band, std::size_t first, std::size_t last);
  void blend(const DrawItem& item, const kernels::Target& target);
  void add_light(const LightPicture& light, const kernels::Target& target,
                 std::span<const Run> runs) const;

  const DrawList& list_;
  const bool hide_;
  std::size_t hidden_ = 0;
  const kernels::SpanKernels& kernels_;
  Tile tile_;
  ItemScan item_scan_;
  RunList runs_;  ///< of one item
  Layer layer_;
};

}  // namespace flatray
