#pragma once
#include <string>

namespace flatray {

/// A module that is loaded at run time: the file that the environment variable names, or else the one called
/// `name` beside the program, then in the folder where modules are installed.
struct ModuleFile {
  const char *name, *variable;
};

/// Those that the program may load.
inline constexpr ModuleFile kGlModule{"flatray_gl.so", "FLATRAY_GL_MODULE"},
    kEmbreeModule{"flatray_embree.so", "FLATRAY_EMBREE_MODULE"},
    kCertifiedModule{"flatray_certified.so", "FLATRAY_CERTIFIED_MODULE"},
    kHdf5Module{"flatray_hdf5.so", "FLATRAY_HDF5_MODULE"},
    kAllModules[] = {kGlModule, kEmbreeModule, kCertifiedModule, kHdf5Module};

/// What a module answers by.
struct LoadedEntry {
  void* entry = nullptr;  ///< the function called `symbol`
  std::string problem;    ///< why there is none; "" where there is
};

/// Gives   the same function for every call: modules stay loaded. Throws std::bad_alloc where memory ends on the way.
LoadedEntry load_module(const ModuleFile& file, const char* symbol);

}  // namespace flatray
