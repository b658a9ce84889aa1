#pragma once
#include <span>
#include <vector>

#include "render/draw_list.h"
#include "render/kernels/span_kernels.h"

namespace flatray {

using kernels::Corner;

/// Corners of a ring that goes down once and up once, from a topmost one on; level edges anywhere.
/// Every row crosses it twice. Near the film: within kMonotoneReach.
using MonotoneRing = std::span<const Corner>;
inline constexpr double kMonotoneReach = 0x1p16;

/// Appends the corners of a path that is such a ring, simple, of at most `most` edges. False, and
/// nothing appended, of any other.
bool append_monotone_ring(const FillPath& path, std::size_t most, std::vector<Corner>& corners);

}  // namespace flatray
