#include <immintrin.h>

#define FLATRAY_TIER baseline
#define FLATRAY_LANES 2
#include "trace/kernels/lane_body.h"
