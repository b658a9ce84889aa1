#include <immintrin.h>

#define FLATRAY_TIER avx2
#define FLATRAY_LANES 4
#include "trace/kernels/lane_body.h"
