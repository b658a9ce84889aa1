#pragma once
#include <cmath>
#include <vector>

#include "render/frame.h"

namespace flatray {

/// Coverage in steps that no 32-bit float rounds across: what a region of light 1 leaves on black.
inline constexpr std::uint32_t kFullCoverage = 64770;

using Steps = std::vector<std::uint32_t>;

/// What each pixel of the box shows of a region, row by row, in nearest steps.
inline Steps steps_of(const Region& region, const PixelBox& box, Coverage mode = Coverage::area) {
  const DrawList list{box.right(), box.bottom(), {0, 0, 0, 1}, mode, {{region, {1, 1, 1, 1}}}};
  const LinearImage light = render_linear(list, {box, 1});
  Steps steps;
  for (std::size_t i = 0; i < light.pixels.size(); i += 3)
    steps.push_back(static_cast<std::uint32_t>(
        std::lround(kFullCoverage * static_cast<double>(light.pixels[i]))));
  return steps;
}

/// Of all of them, in pixels.
inline double covered_area(const Steps& steps) {
  double sum = 0;
  for (const std::uint32_t s : steps) sum += s;
  return sum / kFullCoverage;
}

}  // namespace flatray
