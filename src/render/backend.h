#pragma once
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "render/frame.h"

namespace flatray {

/// Turns draw lists into pixels. Opened once, used for every frame, by several threads at a time.
class Renderer {
 public:
  virtual ~Renderer() = default;

  /// Error   what this back end cannot draw: Trouble::unavailable.
  virtual Result<void> draw(const DrawList& list, const FrameOptions& options,
                            Image& out) const = 0;
  virtual Result<void> draw(const DrawList& list, const FrameOptions& options,
                            LinearImage& out) const = 0;

  /// All that its pixels depend on besides the draw list, as manifests name it: "software".
  virtual std::string description() const = 0;
};

/// What the user chose of a back end.
struct BackendChoice {
  unsigned threads = 1;  ///< that will draw at the same time
  unsigned samples = 4;  ///< of a pixel, where the back end takes samples: 4, 16 or 64
};

/// One way to draw. Nothing of it is loaded or started before `open`.
struct Backend {
  const char* name;
  const char* summary;
  /// Error   Trouble::unavailable, and what to install.
  Result<std::unique_ptr<Renderer>> (*open)(const BackendChoice& choice);
};

/// Registered back ends by name.
std::vector<const Backend*> backends();

}  // namespace flatray
