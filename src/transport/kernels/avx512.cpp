#include <immintrin.h>

#define FLATRAY_TIER avx512
#define FLATRAY_LANES 8
#include "transport/kernels/flights_body.h"
