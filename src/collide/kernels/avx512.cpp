#include <immintrin.h>

#define FLATRAY_TIER avx512
#define FLATRAY_LANES 8
#include "collide/kernels/sweep_body.h"
// After it.
#include "collide/kernels/proof_body.h"
#include "collide/kernels/sight_body.h"
// After them.
#include "collide/kernels/pairs_body.h"
