#pragma once
#include <cmath>
#include <functional>

#include "render/frame.h"

namespace flatray {

/// Coverage in steps that no 32-bit float rounds across: what a region of light 1 leaves on black.
inline constexpr std::uint32_t kFullCoverage = 64770;

using RunSink = std::function<void(int y, int x_begin, int x_end, std::uint32_t steps)>;

/// Calls `sink` with each pixel of the box that shows some of the region, nearest steps.
inline void scan(const Region& region, Coverage mode, const PixelBox& box, const RunSink& sink) {
  DrawList list{box.right(), box.bottom(), {0, 0, 0, 1}, mode, {}};
  DrawItem item;
  item.region = region;
  item.colour = {1, 1, 1, 1};
  list.items.push_back(std::move(item));
  const LinearImage light = render_linear(list, {box, 1});
  for (int y = 0; y < box.height; ++y)
    for (int x = 0; x < box.width; ++x) {
      const auto at = static_cast<std::size_t>(y * box.width + x);
      const auto steps = std::lround(kFullCoverage * static_cast<double>(light.pixels[3 * at]));
      if (steps > 0) sink(box.y + y, box.x + x, box.x + x + 1, static_cast<std::uint32_t>(steps));
    }
}

}  // namespace flatray
