#pragma once
#include <cstdint>
#include <functional>
#include <span>

#include "render/draw_list.h"
#include "render/kernels/span_kernels.h"

namespace flatray {

/// Coverage of a pixel in exact steps of 1/kFullCoverage: floor(kFullCoverage * area). The steps
/// contain those of 8 bits: floor(255 area + 1/2) == (steps / 127 + 1) / 2. 510 * 127 has one
/// factor 2, so that of the simple areas only 0, 1/2 and 1 lie on a step.
inline constexpr std::uint32_t kFullCoverage = 510 * 127;
static_assert(kFullCoverage == kernels::kFullSteps);

/// Nearest of the 255 levels, halves up.
inline std::uint32_t coverage_level(std::uint32_t steps) { return (steps / 127 + 1) / 2; }

/// Middle of the step as a share of the pixel; exactly 0 and 1 at the ends.
inline float coverage_share(std::uint32_t steps) { return kernels::share(steps); }

/// Rectangle of pixels, rows top-down.
struct PixelBox {
  int x = 0, y = 0, width = 0, height = 0;
};

/// What a coverage scan counted.
struct CoverageStats {
  std::uint64_t edge_pixels = 0;      ///< pixels an outline passes through
  std::uint64_t exact_fallbacks = 0;  ///< of these, decided by exact arithmetic
};

/// Receives runs of equal coverage > 0 from left to right, rows from top to bottom.
using RunSink = std::function<void(int y, int x_begin, int x_end, std::uint32_t steps)>;

/// Coverage of each pixel of `box` by a region.
///
/// Units   film coordinates are pixels, y down; pixel (i, j) is [i, i+1] x [j, j+1].
/// Gives   Coverage::area: floor(kFullCoverage * area of region inside the pixel), exact for paths
///         for the doubles given. Coverage::centre: full where the pixel's centre is inside, exact;
///         a centre on an outline belongs to the region right of or below it (top-left rule).
/// Error   paths exact, but for pixels crowded with edges (docs/NUMERICS.md); rings in area mode within one step (double, <= 1e-9 of a pixel); arcs in
///         both modes in doubles: docs/NUMERICS.md.
/// Cost    O(edges in the rows + edge pixels); rationals for pixels within the error bound of a
///         step.
CoverageStats scan(const FillPath& path, Coverage mode, const PixelBox& box, const RunSink& sink);
CoverageStats scan(const FillRing& ring, Coverage mode, const PixelBox& box, const RunSink& sink);
CoverageStats scan(const FillArcs& arcs, Coverage mode, const PixelBox& box, const RunSink& sink);

}  // namespace flatray
