#pragma once
#include "app/frames/frame_source.h"

namespace flatray {

/// Frames of a video that each thread draws before what was drawn is written: as many as need
/// little memory.
std::size_t frames_a_turn(const RenderJob& job);

/// Draws all frames into one file, in order: threads draw the next ones while those before are
/// written and, by a program, made into a video.
/// Gives   nothing written where it was interrupted or failed, and no file.
JobResult make_video(const RenderJob& job, const FrameSource& source,
                     const std::vector<unsigned>& frames, unsigned threads,
                     const std::function<void()>& done);

}  // namespace flatray
