#include <immintrin.h>

#define FLATRAY_TIER avx2
#define FLATRAY_KERNELS kAvx2
#define FLATRAY_LANES 4
#include "collide/kernels/pairs_body.h"
