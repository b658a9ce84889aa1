#pragma once
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "base/result.h"
#include "render/gl/module.h"

namespace flatray::gl {

/// The module flatray_gl.so with a Mesa it has opened. Contexts are made when first needed and kept
/// for the next tile; any number of threads may draw.
class LoadedModule {
 public:
  /// Loads the file that FLATRAY_GL_MODULE names, or else the module beside the program or where it
  /// is installed.
  /// `maker`: "osmesa", "egl", or "gl" for the first of these that works.
  /// Error   Trouble::unavailable, and what to install.
  static Result<std::unique_ptr<LoadedModule>> open(const std::string& maker, unsigned threads);
  ~LoadedModule();
  LoadedModule(const LoadedModule&) = delete;
  LoadedModule& operator=(const LoadedModule&) = delete;

  const FlatrayGlInfo& info() const { return info_; }
  /// Error   Trouble::unavailable where GL fails.
  Result<void> draw(const FlatrayGlTile& tile);

 private:
  explicit LoadedModule(const FlatrayGlModule& module) : module_(module) {}
  Result<void> start(const std::string& maker, unsigned threads);
  Result<FlatrayGlContext*> take();

  const FlatrayGlModule& module_;
  FlatrayGlDevice* device_ = nullptr;
  FlatrayGlInfo info_{};
  std::mutex mutex_;  // of the list of contexts; each context belongs to who has taken it
  std::vector<FlatrayGlContext*> free_;
};

}  // namespace flatray::gl
