#include "base/module_file.h"

#include <cstdlib>
#include <filesystem>
#include <vector>

#include "base/shared_library.h"

namespace flatray {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> candidates(const ModuleFile& file) {
  const char* named = std::getenv(file.variable);
  if (named != nullptr && *named != '\0') return {named};
  std::error_code error;
  const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
  return {folder / file.name, folder / FLATRAY_MODULE_FOLDER / file.name};
}

}  // namespace

LoadedEntry load_module(const ModuleFile& file, const char* symbol) {
  const std::vector<fs::path> files = candidates(file);
  std::error_code ignored;
  for (const fs::path& one : files) {
    if (!fs::exists(one, ignored)) continue;
    const SharedLibrary library(one.c_str());
    if (!library) return {nullptr, library.problem()};
    void* entry = library.find<void>(symbol);
    return {entry, entry == nullptr ? one.string() + " is not a module of flatray" : ""};
  }
  return {nullptr, "the module " + files.front().string() + " is not there"};
}

}  // namespace flatray
