#pragma once
#include <string>

namespace flatray {

/// A module that is loaded at run time: the file that the environment variable names, or else the one called
/// `name` beside the program, then in the folder where modules are installed.
struct ModuleFile {
  const char *name, *variable;
};

/// The variables of all modules.
inline constexpr const char* kModuleVariables[] = {"FLATRAY_GL_MODULE", "FLATRAY_EMBREE_MODULE",
                                                   "FLATRAY_CERTIFIED_MODULE"};

/// What a module answers by.
struct LoadedEntry {
  void* entry = nullptr;  ///< the function called `symbol`
  std::string problem;    ///< why there is none; "" where there is
};

/// Gives   the same function for every call: modules stay loaded.
LoadedEntry load_module(const ModuleFile& file, const char* symbol);

}  // namespace flatray
