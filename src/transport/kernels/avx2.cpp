#include <immintrin.h>

#define FLATRAY_TIER avx2
#define FLATRAY_LANES 4
#include "transport/kernels/flights_body.h"
