#pragma once
#include <functional>
#include <memory>

#include "trace/tracer.h"

namespace flatray {

/// Whether products of the walls' numbers may leave the range where bounds are good for something.
bool is_unusual(const Surfaces& walls);

/// Straight walls whose coordinates are too large or too small for the lanes, times a power of two
/// that makes them fit: no answer changes where no product rounds. Rays whose numbers would round go
/// to `as_given`.
///
/// Needs   `walls` to outlive it; `as_given` made of them; `build` to make what answers of others.
/// Gives   nullptr where a wall's number would round, or there are curves; then `as_given` is kept.
std::unique_ptr<Accelerator> trace_rescaled(
    const Surfaces& walls, std::unique_ptr<Accelerator>& as_given,
    const std::function<std::unique_ptr<Accelerator>(const Surfaces&)>& build);

}  // namespace flatray
