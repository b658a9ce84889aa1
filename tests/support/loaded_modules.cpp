// Test programs lie in a folder of their own: where the modules are that the program finds beside it.
#include <cstdlib>

#include "support/paths.h"

namespace {

const bool kNamed = [] {
  for (const auto& [variable, file] : {std::pair{"FLATRAY_GL_MODULE", "/flatray_gl.so"},
                                       {"FLATRAY_EMBREE_MODULE", "/flatray_embree.so"},
                                       {"FLATRAY_CERTIFIED_MODULE", "/flatray_certified.so"}})
    setenv(variable, flatray::binary_path(file).c_str(), 1);
  return true;
}();

}  // namespace
