#pragma once
#include <string>

namespace flatray {

extern const char* const kVersion;  ///< "0.1.0"

/// What `flatray --version` prints: version, compiler, build type, instruction-set tiers, features,
/// libraries, back ends. Loads the GL module, where it is, to say of which Mesa it is.
std::string version_text();

}  // namespace flatray
