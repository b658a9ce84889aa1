#include "base/shared_library.h"

#include <dlfcn.h>

#include <cerrno>
#include <cstring>
#include <new>

namespace flatray {
namespace {

// What dlerror() says of a call that failed, begun with errno 0. Memory that is refused to the loader is in errno, or,
// where the kernel refuses it a mapping, in the words alone.
std::string words_unless_memory() {
  const bool refused = errno == ENOMEM;
  const char* words = ::dlerror();
  if (refused || words == nullptr || std::strstr(words, std::strerror(ENOMEM)) != nullptr)
    throw std::bad_alloc();
  return words;
}

}  // namespace

SharedLibrary::SharedLibrary(const char* file) {
  errno = 0;
  handle_ = ::dlopen(file, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (handle_ == nullptr) problem_ = words_unless_memory();
}

void* SharedLibrary::symbol(const char* name) const {
  errno = 0;
  void* found = ::dlsym(handle_, name);
  if (found == nullptr) words_unless_memory();
  return found;
}

}  // namespace flatray
