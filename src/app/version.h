#pragma once
#include <string>

namespace flatray {

extern const char* const kVersion;  ///< "0.1.0"

/// What `flatray --version` prints: version, compiler, build type, instruction-set tiers, features,
/// libraries.
std::string version_text();

}  // namespace flatray
