#pragma once
#include <string>

namespace flatray {

/// A shared library that is loaded at run time and stays loaded: neither Mesa nor what else has threads
/// survives being unloaded while they end. Throws std::bad_alloc where it is not loaded, or a name in it
/// not found, because memory has run out: that says nothing of what is installed.
class SharedLibrary {
 public:
  explicit SharedLibrary(const char* file);
  explicit operator bool() const { return handle_ != nullptr; }
  /// Why it is not loaded; "" where it is.
  const std::string& problem() const { return problem_; }
  /// Null where it has no such name.
  template <class Function>
  Function* find(const char* name) const {
    return reinterpret_cast<Function*>(symbol(name));
  }

 private:
  void* symbol(const char* name) const;
  void* handle_ = nullptr;
  std::string problem_;
};

}  // namespace flatray
