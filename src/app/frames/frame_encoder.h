#pragma once
#include <variant>
#include <vector>

#include "app/frames/render_job.h"
#include "image/png.h"

namespace flatray {

/// One drawn picture, encoded, with what its record says of it but frame and file.
struct Encoded {
  std::vector<std::byte> bytes;
  FrameRecord record;
  std::vector<std::byte> error_bytes{};  ///< of the picture of its error, where one is wanted
};

/// Draws frames of a job one after another and encodes them in its format; a frame that shows what
/// the one before did is not encoded again, nor are the bands of a PNG that do.
class FrameEncoder {
 public:
  /// `stop` is FrameOptions::stop.
  FrameEncoder(const RenderJob& job, unsigned threads, bool (*stop)() = nullptr);

  /// A frame of the job: its view where it has one, else what the plan draws. Valid until the next
  /// frame; null where `stop` ended it.
  /// Error   the draw list's; what the job's back end cannot draw.
  Result<const Encoded*> encode(const RenderPlan& plan, const Timeline& timeline, unsigned frame);
  const DrawCounts& counts() const;
  std::size_t encoded() const { return encoded_; }  ///< pictures encoded so far
  const PngEncoder& png() const { return png_; }

 private:
  using Drawer = std::variant<FrameDrawer<Image>, FrameDrawer<LinearImage>>;

  Result<const Encoded*> encode_film(const RenderPlan& plan, const Timeline& timeline,
                                     unsigned frame);
  void keep_report();
  template <class Picture>
  Result<void> encode(FrameDrawer<Picture>& drawer, DrawList list);
  template <class Picture>
  void keep(const Picture& picture, const RowsChanged& changed);

  const RenderJob& job_;
  LightReport report_;
  const FrameOptions options_;
  Drawer drawer_;
  PngEncoder png_;
  Encoded out_;
  std::size_t encoded_ = 0;
};

}  // namespace flatray
