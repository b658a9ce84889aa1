#pragma once
#include "geom/predicates.h"
#include "geom/ray.h"

namespace flatray {

/// Whether `point` lies on the closed segment. Exact.
bool lies_on(const Vec2& point, const Segment& segment);

}  // namespace flatray
