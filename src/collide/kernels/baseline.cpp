#define FLATRAY_TIER baseline
#define FLATRAY_LANES 4
#include "collide/kernels/sweep_body.h"
