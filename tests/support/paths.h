#pragma once
#include <string>

namespace flatray {

// Where the project's sources and this build lie, with `path` behind. Functions, so that no test's object depends on the folder.
std::string source_path(const std::string& path = {});
std::string binary_path(const std::string& path = {});

}  // namespace flatray
