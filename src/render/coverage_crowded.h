#pragma once
#include <span>

#include "render/coverage_edges.h"

namespace flatray {

/// More edges than this inside one pixel are a crowd: what pairs of them cross would cost their
/// square and more.
inline constexpr std::size_t kCrowd = 64;
/// Strips a crowded pixel is cut into.
inline constexpr int kStrips = 128;

/// Whether more than kCrowd of the edges meet the open pixel; exact, so that it depends on nothing
/// else.
bool is_crowded(std::span<const ScanEdge> edges, int column, int row);

/// Nearest step of the area of a crowded pixel: along the middle of each strip the exact order of
/// windings, as wide as it is there.
///
/// Needs   as exact_steps.
/// Error   of the area at most L / (2 kStrips), L the horizontal length of the edges inside the
///         pixel: the covered width changes from one height to another by no more than the edges
///         move sideways between them. Besides that, rounding of each crossing by some ulps of the
///         edge's length.
/// Cost    kStrips times O(n log n).
std::uint32_t crowded_steps(std::span<const ScanEdge> edges, int winding, int column, int row,
                            FillRule rule);

}  // namespace flatray
