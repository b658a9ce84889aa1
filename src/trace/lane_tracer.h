#pragma once
#include "base/isa.h"
#include "trace/cells.h"
#include "trace/tracer.h"

namespace flatray {

/// Nearest hits by the kernels of tier `isa`: through cells, or every segment where there are none.
/// What the lanes are not certain of is decided one by one, circles after the segments. Without
/// `cells` every ray is.
///
/// Needs   `walls` to outlive it, the cells to be theirs.
/// Gives   the same bits from every tier, and as every exact tracer.
std::unique_ptr<Accelerator> trace_in_lanes(const Surfaces& walls, std::optional<CellGrid> cells,
                                            Isa isa);

}  // namespace flatray
