#pragma once
#include <optional>

#include "app/frames/frame_encoder.h"

namespace flatray {

/// How a job's frames are planned, towards a goal of its light, which must live as long.
RenderPlan plan_of(const RenderJob& job, const LightGoal& goal);

/// What frames of a job are drawn from. What all of them have in common is made once, first.
class FrameSource {
 public:
  /// `count` frames, of which `first` is one; `threads` make what they have in common.
  FrameSource(const RenderJob& job, const Timeline& timeline, unsigned first, std::size_t count,
              unsigned threads, const Told& told);
  FrameSource(const FrameSource&) = delete;
  FrameSource& operator=(const FrameSource&) = delete;

  /// A frame, by any thread with an encoder of its own; valid until that encodes another.
  /// Gives   null where it was interrupted.
  Result<const Encoded*> encode(unsigned frame, FrameEncoder& encoder) const;

  /// Of what all frames have in common.
  const DrawCounts& drawn() const { return drawn_; }
  std::size_t encoded() const { return encoded_; }

 private:
  const RenderJob& job_;
  const Timeline& timeline_;
  const LightGoal goal_;
  ShownLight kept_light_;
  RenderPlan plan_;
  Diagnostics problems_;
  std::optional<Encoded> still_;
  DrawCounts drawn_;
  std::size_t encoded_ = 0;
};

}  // namespace flatray
