#include <fmt/core.h>

#include "app/answers/measure.h"
#include "app/files/scene_input.h"
#include "app/frames/render_request.h"
#include "app/help/build_parts.h"
#include "app/verb.h"
#include "base/counted.h"
#include "base/isa.h"
#include "base/left_out.h"
#include "collide/scene_timeline.h"
#include "render/ray_walls.h"

namespace flatray::explain_verb {
namespace {

constexpr std::size_t kMeasuredFrames = 24;

struct Options : Arguments {
  RenderRequest request;
  bool measure = false;

  void rows(OptionTable& row) {
    row("--measure", "draw the frames, write nothing, and say what is saved", measure);
    row("-f, --frames LIST", "frames to measure (default: the first 24)", request.frames,
        &parse_frames);
    row("--keep-all", "as if nothing were left out", request.keep_all);
    request.row_of_size(row);
    row_of_threads(row, request.scene.limits.threads);
    row(kJsonRow);
    request.scene.rows(row);
    request.read_size(row);
  }
};

// What the rays of the first frame are traced by.
Result<Savings> walls_of(const RenderJob& job) {
  if (!need_of_ray_walls(job.scene).needed) return ray_wall_choices(job.scene, {}, job.tracer);
  FLATRAY_TRY(timeline, make_timeline(job.scene, job.seed, job.last_frame));
  const unsigned frame = job.frames.empty() ? 1 : job.frames.front();
  return ray_wall_choices(job.scene, at(*timeline, frame), job.tracer);
}

Result<Savings> decisions(const RenderJob& job, unsigned threads) {
  const RenderPlan plan = make_plan(job.scene, job.keep_all);
  Savings rows;
  const auto left_out = left_out_of_build();
  for (const MissingPart& part : missing_parts(job.scene, left_out))
    rows.push_back({"build " + part.name, "left out",
                    (part.concerns ? "concerns this scene: " : "does not concern this scene: ") +
                        part.reason});
  if (left_out.empty()) rows.push_back({"build", "whole", "configured with every optional part"});
  rows.insert(rows.end(), plan.choices.begin(), plan.choices.end());
  FLATRAY_TRY(walls, walls_of(job));
  rows.insert(rows.end(), walls->begin(), walls->end());
  const std::size_t count = plan.still ? 1 : job.frames.size();
  const Spread spread = flatray::spread(job, count, threads);
  rows.push_back({"instructions", isa_name(active_isa()),
                  "the fastest tier of this machine, or FLATRAY_ISA; same bits on all"});
  rows.push_back(
      {"threads",
       fmt::format("{} at once, {} each", counted(spread.frames_at_once, "frame"),
                   counted(spread.threads_each, "thread")),
       fmt::format("{}, {} to draw", counted(threads, "thread"), counted(count, "frame"))});
  rows.push_back(
      {"memory",
       fmt::format("{:.1f} MB of pictures",
                   static_cast<double>(picture_bytes_at_once(job, count, threads)) / 1e6),
       fmt::format("of {}x{} and what lies still in them, at most; scene and outlines come on top: "
                   "flatray help limits",
                   job.picture().width, job.picture().height)});
  return rows;
}

Result<VerbOutput> run(const Options& options) {
  FLATRAY_TRY(jobs, make_jobs(options, options.request));
  FLATRAY_TRY(rows, decisions(jobs->front(), options.request.threads()));
  if (options.measure) {
    RenderJob job = jobs->front();
    if (!options.request.frames && job.frames.size() > kMeasuredFrames)
      job.frames.resize(kMeasuredFrames);
    for (const auto measure : {&measured_savings, &measured_walls}) {
      FLATRAY_TRY(savings, measure(job));
      rows->insert(rows->end(), savings->begin(), savings->end());
    }
  }
  Table table({"part", "decision", "reason"});
  for (const auto& [part, decision, reason] : *rows) table.add({part, decision, reason});
  return VerbOutput{.table = std::move(table)};
}

}  // namespace

extern const Verb entry = {"explain", "SCENE",
                           "show what a render of the scene would do and leave out, and why",
                           kCommand<Options, &run>,
                           "  flatray explain scenes/demo.toml\n"
                           "  flatray explain --measure -f 1..48 scenes/demo.toml\n"};

}  // namespace flatray::explain_verb
