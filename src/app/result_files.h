#pragma once
#include <filesystem>

#include "app/value.h"
#include "study/experiment.h"

namespace flatray {

/// Writes the files of a result into a folder.
/// Gives   their paths, all in that folder: what is not a plain letter in a name is "_" there.
Result<Values> write_files(const ExperimentResult& result, const std::filesystem::path& folder);

}  // namespace flatray
