#include <immintrin.h>

#define FLATRAY_TIER avx2
#define FLATRAY_LANES 8
#include "collide/kernels/sweep_body.h"

#undef FLATRAY_LANES
#define FLATRAY_LANES 4
#include "collide/kernels/proof_body.h"
#include "collide/kernels/sight_body.h"
// After them.
#include "collide/kernels/pairs_body.h"
