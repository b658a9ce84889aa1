#pragma once
#include "trace/kernels/walk.h"

namespace flatray {

/// What kernels/walk.h says of one ray alone, whose way may branch where lanes may not: the record
/// of the wall that surely is the first met, lanes::kNoRecord or lanes::kDoubt.
///
/// Needs   a ray as WalkKernels::prepare makes it, in the first place of each column.
int walk_single(const lanes::Grid& grid, const lanes::Walking& ray);
/// The same without cells: every record.
int scan_single(const lanes::Grid& grid, const lanes::Walking& ray);

}  // namespace flatray
