#pragma once
#include "app/verb.h"

namespace flatray {

/// The options of a folder: its flatray.toml, whose keys are the long names of options, of any
/// verb.
inline constexpr const char* kProjectConfig = "flatray.toml";

/// Adds what it says of options that neither the command line nor the environment gives; keys
/// of other verbs are passed over. A file that is not there says nothing. To the problems of the
/// arguments: Trouble::missing where it cannot be read or is not a plain file; Trouble::usage with
/// the place of each key that is not an option and each value that is not one.
void add_project_config(std::span<const Option> options, Arguments& arguments);

}  // namespace flatray
