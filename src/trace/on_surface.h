#pragma once
#include "geom/predicates.h"
#include "geom/ray.h"

namespace flatray {

/// Whether `point` lies on the closed segment. Exact.
bool lies_on(const Vec2& point, const Segment& segment);

/// Side of a circle `point` lies on: positive outside, zero on it, negative inside. Exact.
Sign circle_side(const Vec2& point, const Circle& circle);

}  // namespace flatray
