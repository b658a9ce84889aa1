#include <immintrin.h>

#define FLATRAY_TIER baseline
#define FLATRAY_KERNELS kBaseline
#define FLATRAY_LANES 2
#include "collide/kernels/pairs_body.h"
