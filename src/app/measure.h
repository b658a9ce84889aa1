#pragma once
#include <string>
#include <vector>

#include "app/render_job.h"

namespace flatray {

/// One line of `flatray explain`.
struct Saving {
  std::string part, decision, reason;
};

/// What leaving out saves: the job's frames drawn and encoded by one thread, nothing written, once
/// as they are, once with everything kept, and once with each thing kept that is left out, in turns.
///
/// Gives   the same bytes every time, or it stops the program.
/// Units   milliseconds of processor time, medians of three rounds.
/// Error   a frame that draws too many corners.
Result<std::vector<Saving>> measured_savings(const RenderJob& job);

/// The measure of the paper, walls looked at and hit over all walls, of the flights of the scene's
/// rays in the first frame of a job; nothing without rays or walls. Of each ray the first 1000
/// bounces count.
Result<std::vector<Saving>> measured_walls(const RenderJob& job);

}  // namespace flatray
