#pragma once
#include "trace/surfaces.h"
#include "tracing.h"

namespace bench {

/// Appends first hits in plain doubles, without bounds, one ray in each of four lanes through the cells
/// of tracer `grid` (goal S6): what exactness is measured against. Only where AVX2 is; rays that leave
/// a wall are not told to pass it by.
void add_plain_lanes(const flatray::Surfaces& walls, Tracings& all);

}  // namespace bench
