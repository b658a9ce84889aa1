#pragma once
#include "base/result.h"
#include "scene/scene.h"

namespace flatray {

/// Why rays of finite speed cannot be followed in a scene: all that reflects or absorbs must stand
/// still or move straight from time to time, neither turning nor changing its size, and be made of
/// segments and circles.
Diagnostics refused_mirrors(const Scene& scene);

}  // namespace flatray
