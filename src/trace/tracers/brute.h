#pragma once
#include <span>

#include "base/isa.h"
#include "trace/hits.h"
#include "trace/surfaces.h"

namespace flatray {

/// Nearest hits by trying every wall: the kernel of tier `isa` rules out what it can, the rest is
/// decided exactly.
///
/// Needs   as many hits as rays.
/// Gives   the same bits from every tier.
/// Cost    O(rays * walls), about 2 ns for eight rays and a wall in the widest tier.
void brute_nearest(const Surfaces& walls, const RayBatch& rays, std::span<NearestHit> hits,
                   Isa isa);

}  // namespace flatray
