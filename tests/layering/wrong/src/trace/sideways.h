#include "base/deep.h"
#include "../geom/up.h"
