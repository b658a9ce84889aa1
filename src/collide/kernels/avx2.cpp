#define FLATRAY_TIER avx2
#define FLATRAY_LANES 8
#include "collide/kernels/sweep_body.h"
