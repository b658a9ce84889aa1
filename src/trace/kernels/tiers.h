#pragma once
#include "base/isa.h"
#include "trace/kernels/lanes.h"

namespace flatray {

/// Kernels of one tier. Needs a tier this machine runs; one that this build lacks gives the
/// portable kernels.
const lanes::Kernels& lane_kernels(Isa isa);

}  // namespace flatray
