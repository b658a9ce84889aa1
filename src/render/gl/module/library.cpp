#include <dlfcn.h>

#include "render/gl/module/maker.h"

namespace flatray::gl {

Library::Library(const char* file) : handle_(dlopen(file, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE)) {}

void* Library::symbol(const char* name) const { return dlsym(handle_, name); }

}  // namespace flatray::gl
