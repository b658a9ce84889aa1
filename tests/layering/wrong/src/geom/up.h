#include "geom/down.h"
#include "trace/up.h"
