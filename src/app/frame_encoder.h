#pragma once
#include <variant>
#include <vector>

#include "app/render_job.h"

namespace flatray {

/// One drawn picture, encoded, with what its record says of it but frame and file.
struct Encoded {
  std::vector<std::byte> bytes;
  FrameRecord record;
};

/// Draws frames of a job one after another and encodes them in its format; a frame that shows what
/// the one before did is not encoded again.
class FrameEncoder {
 public:
  /// `stop` is FrameOptions::stop.
  FrameEncoder(const RenderJob& job, unsigned threads, bool (*stop)() = nullptr);

  /// Valid until the next frame; null where `stop` ended it.
  /// Error   the list's; what the job's back end cannot draw.
  Result<const Encoded*> encode(Result<DrawList> list);
  const DrawCounts& counts() const;
  std::size_t encoded() const { return encoded_; }  ///< pictures encoded so far

 private:
  template <class Picture>
  Result<void> encode(FrameDrawer<Picture>& drawer, DrawList list);
  template <class Picture>
  void keep(const Picture& picture);

  const RenderJob& job_;
  const FrameOptions options_;
  std::variant<FrameDrawer<Image>, FrameDrawer<LinearImage>> drawer_;
  Encoded out_;
  std::size_t encoded_ = 0;
};

}  // namespace flatray
