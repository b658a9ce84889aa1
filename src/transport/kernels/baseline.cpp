#include <immintrin.h>

#define FLATRAY_TIER baseline
#define FLATRAY_LANES 2
#include "transport/kernels/flights_body.h"
