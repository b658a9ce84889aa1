#pragma once
#include <vector>

#include "render/coverage.h"

namespace flatray {

/// The pixels of a box that bounds reach into; none where they lie beside it.
PixelBox pixels_around(const Bounds& bounds, const PixelBox& box);

/// A clear layer over a band, on which items are painted before all of them are faded as one.
class Layer {
 public:
  /// Clears the pixels of `part`; of the target only where it lies is taken.
  void clear(const kernels::Target& band, const PixelBox& part, int rows);
  kernels::Target target() { return {rgba_.data(), x_, y_, width_}; }
  /// new = layer * opacity + old * (1 - alpha * opacity), premultiplied.
  void lay_over(const kernels::Target& band, const PixelBox& part, float opacity) const;

 private:
  int x_ = 0, y_ = 0, width_ = 0;
  std::vector<float> rgba_;
};

}  // namespace flatray
