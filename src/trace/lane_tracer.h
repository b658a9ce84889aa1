#pragma once
#include <memory>
#include <optional>

#include "base/isa.h"
#include "trace/cells.h"
#include "trace/tracer.h"

namespace flatray {

/// Nearest hits by the kernels of tier `isa`: through cells, or every segment where there are none.
/// What the lanes are not certain of is decided one by one, and so are Bezier curves, after the
/// segments. Where coordinates are too large or too small for lanes, every ray is decided one by one.
///
/// Needs   `walls` to outlive it; `cells` of them, none where coordinates leave no room for lanes.
/// Gives   the same bits from every tier, and as every exact tracer.
std::unique_ptr<Accelerator> trace_in_lanes(const Surfaces& walls, std::optional<CellGrid> cells,
                                            Isa isa, unsigned threads = 1);

}  // namespace flatray
