#pragma once
#include <memory>
#include <stdexcept>
#include <string>

#include "base/shared_library.h"

namespace flatray::gl {

/// A library that people install. Where it is not there, or lacks a function, std::runtime_error says what to
/// install: so does all of the module tell what fails, and its entry hands that on (module.cpp).
class InstalledLibrary {
 public:
  InstalledLibrary(const char* file, const char* packages)
      : library_(file),
        lacking_(std::string(file) + " lacks what flatray calls: install " + packages) {
    if (!library_) throw std::runtime_error(library_.problem() + ": install " + packages);
  }
  template <class Function>
  Function* find(const char* name) const {
    return needed(library_.find<Function>(name));
  }
  template <class Function>
  Function* needed(Function* found) const {
    return found != nullptr ? found : throw std::runtime_error(lacking_);
  }

 private:
  const SharedLibrary library_;
  const std::string lacking_;
};

/// A loaded Mesa that makes contexts. One path of GL stands on any of these.
class Maker {
 public:
  /// A GL context; belongs to no thread until it is made current.
  class Context {
   public:
    Context() = default;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    virtual ~Context() = default;
    virtual bool enter() = 0;  ///< makes it current for this thread
    virtual void leave() = 0;
  };

  virtual ~Maker() = default;
  virtual const char* name() const = 0;
  virtual std::unique_ptr<Context> create() = 0;
  virtual void* function(const char* name) const = 0;
};

/// Fails where this build or this machine lacks it.
std::unique_ptr<Maker> open_osmesa();
std::unique_ptr<Maker> open_egl();

}  // namespace flatray::gl
