#define FLATRAY_TIER portable
#define FLATRAY_LANES 4
#include "collide/kernels/sweep_body.h"
