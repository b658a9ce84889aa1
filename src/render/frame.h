#pragma once
#include <optional>

#include "image/image.h"
#include "render/coverage.h"
#include "render/plan.h"

namespace flatray {

/// Pixels of the film to draw; the whole film unless a crop is asked for.
struct FrameOptions {
  std::optional<PixelBox> crop;
  unsigned threads = 1;  ///< for the tiles of one frame
};

/// What a frame shows, before pixels.
DrawList draw_list(const RenderPlan& plan, const Timeline& timeline, unsigned frame);

/// Pixels of a draw list by the software back end. Same bytes for any thread count and crop.
Image render_image(const DrawList& list, const FrameOptions& options);
LinearImage render_linear(const DrawList& list, const FrameOptions& options);

}  // namespace flatray
