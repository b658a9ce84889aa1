#pragma once
#include <memory>
#include <string>

namespace flatray::gl {

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
  virtual std::unique_ptr<Context> create(std::string& error) = 0;
  virtual void* function(const char* name) const = 0;
};

/// Null where this build or this machine lacks it; `error` says what to install.
std::unique_ptr<Maker> open_osmesa(std::string& error);
std::unique_ptr<Maker> open_egl(std::string& error);

}  // namespace flatray::gl
