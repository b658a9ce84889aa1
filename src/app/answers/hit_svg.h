#pragma once
#include <span>
#include <string>

#include "app/answers/hit_report.h"

namespace flatray {

/// A diagram of clips: the entities asked about, every ray, and the part of it inside, thick, with
/// the times of its ends, where there is room. A ray without end stops at the edge of the picture.
std::string svg_of(const Scene& scene, const FrameState& state,
                   std::span<const std::uint32_t> entities, std::span<const HitReport> reports);

}  // namespace flatray
