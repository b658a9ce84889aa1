#pragma once
#include "collide/kernels/proof.h"
#include "collide/kernels/sight.h"
#include "collide/kernels/sweep.h"

// The kernels of contacts of many pairs, of each instruction-set tier.
namespace flatray::pairs {

struct Kernels {
  sight::Kernel look;
  sweep::Kernel guess;
  proof::Kernel prove;
};

namespace portable {
extern const Kernels kKernels;
}
namespace baseline {
extern const Kernels kKernels;
}
namespace avx2 {
extern const Kernels kKernels;
}
namespace avx512 {
extern const Kernels kKernels;
}

}  // namespace flatray::pairs
