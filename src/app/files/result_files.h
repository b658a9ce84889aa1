#pragma once
#include <filesystem>
#include <vector>

#include "app/files/outputs.h"
#include "base/json.h"
#include "study/experiment.h"

namespace flatray {

/// Whether all files of a result may be written into a folder; their content counts as far as
/// Outputs::allow() looks at it.
/// Gives   their paths, all in that folder: what is not a plain letter in a name is "_" there.
Result<std::vector<std::filesystem::path>> allow_files(const ExperimentResult& result,
                                                       const std::filesystem::path& folder,
                                                       const Outputs& outputs);

/// Writes the files of a result into a folder, all or none where one of them must not be replaced.
Result<Values> write_files(const ExperimentResult& result, const std::filesystem::path& folder,
                           const Outputs& outputs);

}  // namespace flatray
