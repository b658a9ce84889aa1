#pragma once
#include <optional>

#include "image/image.h"
#include "render/coverage/bands.h"
#include "render/plan.h"

namespace flatray {

/// Pixels of the film to draw; the whole film unless a crop is asked for.
struct FrameOptions {
  std::optional<PixelBox> crop;
  unsigned threads = 1;   ///< for the tiles of one frame
  bool keep_all = false;  ///< draw what is hidden and what has not changed, too
  /// Asked before each band or tile, and before each row of an item, by any thread: true leaves it
  /// and all after it undrawn, and stays true.
  bool (*stop)() = nullptr;
  LightReport* light_report = nullptr;  ///< LightRun::report

  bool stopped() const { return stop != nullptr && stop(); }
};
inline PixelBox crop_of(const DrawList& list, const FrameOptions& options) {
  return options.crop.value_or(PixelBox{0, 0, list.width, list.height});
}

/// What was drawn and what was not, in bands of rows. What is said to be left out is not among the
/// scans: these count the work.
struct DrawCounts {
  std::uint64_t bands = 0;          ///< drawn
  std::uint64_t kept_bands = 0;     ///< not drawn: they show what they showed in the frame before
  std::uint64_t items = 0;          ///< items of the bands drawn
  std::uint64_t hidden_items = 0;   ///< of these, left out: those above cover the whole band
  std::uint64_t pixels = 0;         ///< of the bands drawn
  std::uint64_t kept_pixels = 0;    ///< of these, as they were in the frame before: not drawn
  std::uint64_t stopped_bands = 0;  ///< not drawn: FrameOptions::stop said so
  std::uint64_t scans = 0;          ///< of an item in a band, to find its pixels

  DrawCounts& operator+=(const DrawCounts& more) {
    bands += more.bands, kept_bands += more.kept_bands;
    items += more.items;
    hidden_items += more.hidden_items;
    pixels += more.pixels, kept_pixels += more.kept_pixels;
    stopped_bands += more.stopped_bands, scans += more.scans;
    return *this;
  }
};

/// What a frame shows, before pixels; its light, where it has any, is traced as `options` say.
/// Error   what takes the frame over Scene::max_corners, by its place in the scene.
Result<DrawList> draw_list(const RenderPlan& plan, const Timeline& timeline, unsigned frame,
                           const FrameOptions& options = {});

/// The software back end for frames drawn one after another: bands in which nothing changed keep
/// their pixels, and the other bands keep those left and right of what changed. The pixels are the
/// same whatever was drawn before.
///
/// Cost    memory for the picture.
template <class Picture>  // Image or LinearImage
class FrameDrawer {
 public:
  explicit FrameDrawer(const FrameOptions& options) : options_(options) {}

  /// Valid until the next frame is drawn.
  const Picture& draw(DrawList list);
  /// Whether the last frame may differ from the one before.
  bool changed() const { return changed_; }
  /// The same of its rows [begin, end), counted from the top of the picture.
  bool changed(int begin, int end) const;
  /// Whether no frame was stopped: what follows one that was is no picture either.
  bool whole() const { return counts_.stopped_bands == 0; }
  const DrawCounts& counts() const { return counts_; }

 private:
  FrameOptions options_;
  bool changed_ = true;
  DrawList list_;
  Bands bands_;
  std::vector<BandChange> changes_;
  Picture picture_;
  DrawCounts counts_;
};

/// Makes a picture of a crop, of undetermined pixels, unless it is one.
void shape_picture(const PixelBox& crop, const DrawList& list, Image& picture);
void shape_picture(const PixelBox& crop, const DrawList& list, LinearImage& picture);

/// Draws one draw list into a picture whose memory is used again.
template <class Picture>  // Image or LinearImage
void render_into(const DrawList& list, const FrameOptions& options, Picture& picture);

/// Pixels of one draw list by the software back end. Same bytes for any thread count and crop.
Image render_image(const DrawList& list, const FrameOptions& options);
LinearImage render_linear(const DrawList& list, const FrameOptions& options);

}  // namespace flatray
