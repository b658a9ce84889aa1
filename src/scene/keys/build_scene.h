#pragma once
#include "scene/imports/imports.h"
#include "scene/load.h"
#include "scene/reading/reader.h"
#include "scene/reading/scene_desc.h"
#include "scene/reading/vocabulary.h"

namespace flatray {

/// Highest frame number: what keeps a list of all of them small.
inline constexpr unsigned kLastFrame = 9'999'999;

/// Checks a description and makes the scene of it; `name` and `hash` are left to the caller.
/// `seed` replaces the scene's.
///
/// Error   every mistake, in the order of the source; what came from overrides last.
Result<LoadedScene> build_scene(const SceneDesc& desc, Imports& imports, const LoadLimits& limits,
                                std::optional<std::uint64_t> seed);

/// Whether a scene that is included is of a version that can be read; if not, a problem.
void check_version(Reader& in, const Value& scene);

/// The keys of every table but the shapes'.
std::vector<TableInfo> language_tables();

}  // namespace flatray
