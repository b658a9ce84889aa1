#pragma once
#include <vector>

#include "app/frames/render_job.h"
#include "app/frames/render_request.h"
#include "app/report/progress.h"
#include "app/verb.h"

namespace flatray {

/// The jobs of a command, with what --resume keeps taken out.
struct WorkList {
  std::vector<Work> works;
  unsigned threads = 1;
};
Result<WorkList> work_list(const std::vector<RenderJob>& jobs, const RenderRequest& request);

/// --dry-run: frames, names and memory, as lines or as the object of --json.
VerbOutput describe(const WorkList& list);

/// What a stop leaves nothing of, in words; null where the same command with --resume goes on.
const char* lost_by_stop(const RenderJob& job);

/// Renders scene after scene. The first failure or Ctrl-C ends it: whole frames and their records
/// stay, the exit code is 6 or 130.
VerbOutput render_all(const Arguments& arguments, const WorkList& list, ProgressMode mode);

}  // namespace flatray
