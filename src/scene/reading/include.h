#pragma once
#include "scene/imports/imports.h"
#include "scene/load.h"
#include "scene/reading/scene_desc.h"

namespace flatray {

/// Takes the scenes a scene includes into its description, and theirs into them: `include` is gone
/// afterwards, `desc.sources` holds all files, each after those it includes.
///
/// Gives   lists with the entries of the files included first, in order, then its own; other keys
///         as the including file has them, else as the last file that has them; the keys of `film`
///         and `camera`, and chains, one by one. A file counts once however often it is included.
/// Error   every file that cannot be read or is wrong, a file that includes itself, a nesting over
///         LoadLimits::max_depth, each with the place of the `include`.
Result<void> take_includes(SceneDesc& desc, const SourcePtr& source, Imports& imports,
                           const LoadLimits& limits);

}  // namespace flatray
