#define FLATRAY_TIER avx512
#define FLATRAY_LANES 16
#include "collide/kernels/sweep_body.h"
