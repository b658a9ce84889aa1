#pragma once
#include <memory>

#include "base/isa.h"
#include "trace/tracer.h"

namespace flatray {

/// Walls in a grid of cells for the kernels of one tier (kernels/walk.h); without a grid, where
/// there can be none, every wall is tried.
///
/// Needs   `walls` to outlive it.
/// Gives   the same bits from every tier, and as every exact tracer.
std::unique_ptr<Accelerator> build_grid(const Surfaces& walls, Isa isa = active_isa());

}  // namespace flatray
