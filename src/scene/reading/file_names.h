#pragma once
#include <filesystem>

#include "scene/reading/scene_desc.h"

namespace flatray {

/// Rewrites the names of the files a description refers to, which are relative to the folder of the
/// file they stand in, so that they lead to the same files from `folder`.
///
/// Needs   `scene`, the name of the scene's file, to which names given by -D are relative.
/// Error   Trouble::usage: the scene is itself the file and came from standard input, so that it
///         has no name. Trouble::invalid: names that are not UTF-8, which no TOML can refer to.
Result<void> rebase_file_names(SceneDesc& desc, const std::filesystem::path& scene,
                               const std::filesystem::path& folder);

}  // namespace flatray
