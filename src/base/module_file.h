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

/// A table of functions that a module gives, or why there is none.
template <class Table>
struct LoadedTable {
  const Table* table = nullptr;
  std::string problem{};
};

/// Needs   a function `symbol` of the module that gives the table; `made_for` is the number in it that tells for which
///         program it was made, `number` that of this one.
template <class Table, class Number>
LoadedTable<Table> load_table(const ModuleFile& file, const char* symbol, Number Table::*made_for,
                              Number number) {
  const LoadedEntry loaded = load_module(file, symbol);
  if (loaded.entry == nullptr) return {nullptr, loaded.problem};
  const Table* table = reinterpret_cast<const Table* (*)()>(loaded.entry)();
  if (table != nullptr && table->*made_for == number) return {table};
  return {nullptr,
          "its module belongs to another version of flatray; build or install both together"};
}

}  // namespace flatray
