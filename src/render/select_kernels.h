#pragma once
#include "base/isa.h"
#include "render/kernels/span_kernels.h"

namespace flatray {

/// The kernels of a tier. Needs one of `available_isas()`.
const kernels::SpanKernels& span_kernels(Isa isa);

}  // namespace flatray
