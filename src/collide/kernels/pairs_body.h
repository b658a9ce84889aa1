// What a tier has for pairs, after its kernels.
#include "collide/kernels/pairs.h"

namespace flatray::pairs::FLATRAY_TIER {

extern const Kernels kKernels;
const Kernels kKernels = {&sight::FLATRAY_TIER::look_at_all, &sweep::FLATRAY_TIER::guess_all,
                          &proof::FLATRAY_TIER::prove_all};

}  // namespace flatray::pairs::FLATRAY_TIER
