#include <immintrin.h>

#define FLATRAY_TIER avx512
#define FLATRAY_KERNELS kAvx512
#define FLATRAY_LANES 8
#include "collide/kernels/pairs_body.h"
