#pragma once
#include <utility>

#include "study/experiment.h"

namespace flatray {

/// Names and what they say.
using Texts = std::vector<std::pair<std::string, std::string>>;

/// Whether this machine has the module that writes HDF5.
Result<void> can_write_hdf5();

/// NAME.h5 of an experiment: a dataset for each of its .npy files, of the same rows and columns,
/// with its caption, and one of its measures (NaN where there is no error, or nothing is expected).
/// Attributes of the file are the texts of `attributes`. The same numbers are the same bytes, of
/// one version of the library.
///
/// Needs   can_write_hdf5().
/// Error   the library fails.
Result<ExperimentResult::File> hdf5_file(const std::string& name, const Texts& attributes,
                                         const ExperimentResult& result);

}  // namespace flatray
