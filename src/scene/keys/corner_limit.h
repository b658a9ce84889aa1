#pragma once
#include "scene/keys/builder.h"

namespace flatray {

/// Counts what a scene keeps of its shapes, curves, gradients, dashes, paths, states and names, with
/// every copy: LoadLimits::max_corners of it.
///
/// Gives   false over the limit: nothing more may be kept.
/// Error   told at `where`, once a scene.
bool take_corners(Builder& builder, std::uint64_t count, const Place& where);

/// What one of these counts for; what each takes beside its corners is part of it.
std::uint64_t corner_count(const Shape& shape);
std::uint64_t corner_count(const std::string& name);
/// Its looks and its name; where rays meet it, also walls, which every copy has of its own.
std::uint64_t corner_count(const Scene& scene, const Entity& entity);
std::uint64_t corner_count(const std::optional<MarkovUse>& markov);

}  // namespace flatray
