// Test programs lie in a folder of their own: where the modules are that the program finds beside it.
#include <cstdlib>

#include "base/module_file.h"
#include "support/paths.h"

namespace {

const bool kNamed = [] {
  for (const flatray::ModuleFile& module : flatray::kAllModules)
    setenv(module.variable, flatray::binary_path(std::string("/") + module.name).c_str(), 1);
  return true;
}();

}  // namespace
