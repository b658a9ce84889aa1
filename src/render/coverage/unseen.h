#pragma once
#include "base/result.h"
#include "scene/scene.h"

namespace flatray {

/// Warnings of what a scene has and frame 1 does not show: rays without a flight, lamps in walls,
/// light that does not come to the film.
///
/// Cost   the walls of the frame; with lamps some thousand rays of light, or paths from pixels to all lamps.
Diagnostics unseen_in(const Scene& scene, std::uint64_t seed);

}  // namespace flatray
