#include "support/paths.h"

namespace flatray {

std::string source_path(const std::string& path) { return FLATRAY_SOURCE_DIR + path; }
std::string binary_path(const std::string& path) { return FLATRAY_BINARY_DIR + path; }

}  // namespace flatray
