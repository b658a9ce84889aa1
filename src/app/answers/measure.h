#pragma once
#include <vector>

#include "app/frames/render_job.h"

namespace flatray {

/// Lines of `flatray explain`.
using Savings = std::vector<RenderPlan::Choice>;

/// What leaving out saves: the job's frames drawn and encoded by one thread, nothing written, as
/// they are, with everything kept, and with each thing kept that is left out, in rounds of turns.
///
/// Gives   counts, which are the same every time; costs and savings with intervals
///         (app/answers/cost.h), or that they cannot be measured. The frames have the same bytes,
///         or it stops the program.
/// Units   instructions where the machine counts them, else milliseconds of processor time.
/// Error   a frame that draws too many corners.
Result<Savings> measured_savings(const RenderJob& job);

/// The measure of the paper, walls looked at and hit over all walls, of the flights of the scene's
/// rays in the first frame of a job; nothing without rays or walls. Of each ray the first 1000
/// bounces count.
Result<Savings> measured_walls(const RenderJob& job);

}  // namespace flatray
