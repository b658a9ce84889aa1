#include <fmt/core.h>

#include <set>

#include "base/entry_named.h"
#include "base/table.h"
#include "collide/scene_timeline.h"
#include "image/compare.h"
#include "render/backend.h"
#include "study/accuracy/point_samples.h"
#include "study/experiment.h"

namespace flatray::backends_experiment {
namespace {

// What the frames of a scene come to.
struct Report {
  Table table{{"scene", "frame", "samples", "worst", "mean", "flat_worst", "edge_pixels", "sampled",
               "rounded", "unexplained"}};
  std::string opened{};  // a line for each back end
  std::uint64_t faults = 0;
};

Result<void> add_frame(const ExperimentContext& context, const Renderer& renderer, unsigned samples,
                       const DrawList& list, unsigned frame, Report& report) {
  Image drawn;
  if (auto done = renderer.draw(list, {std::nullopt, 1}, drawn); !done) return done;
  const Image exact = render_image(list, {std::nullopt, context.threads});
  const Difference difference = compare(drawn, exact).value();
  const PointSampled sampled =
      point_sampled(list, sample_places(list.coverage, samples), context.threads);
  const DifferenceCauses why = difference_causes(drawn, exact, sampled, edge_pixels(list));
  report.table.add({context.scene.name, frame, samples,
                    static_cast<std::uint64_t>(difference.worst), difference.mean,
                    static_cast<std::uint64_t>(why.flat_worst), why.edge, why.sampled, why.rounded,
                    why.unexplained});
  if (!why.coverage_alone()) ++report.faults;
  return {};
}

Result<void> add_frames(const ExperimentContext& context, unsigned samples, Report& report) {
  const Backend* backend = entry_named(flatray::backends(), "gl");
  if (backend == nullptr)
    return fail({}, "this build has no GL back end", "", Trouble::unavailable);
  FLATRAY_TRY(renderer, backend->open({context.threads, samples}));
  report.opened += (*renderer)->description() + "\n";
  const unsigned last = context.scene.frames;
  FLATRAY_TRY(timeline, make_timeline(context.scene, context.scene.seed, last));
  const auto plan = make_plan(context.scene, false);
  for (const unsigned frame : std::set<unsigned>{1, (last + 1) / 2, last}) {
    FLATRAY_TRY(list, draw_list(plan, *timeline, frame));
    FLATRAY_TRY(added, add_frame(context, **renderer, samples, *list, frame, report));
  }
  return {};
}

Result<ExperimentResult> run(const ExperimentContext& context) {
  Report report;
  for (const unsigned samples : {4U, 16U}) {
    FLATRAY_TRY(added, add_frames(context, samples, report));
  }
  const auto& [table, opened, faults] = report;
  ExperimentResult result;
  result.holds = faults == 0;
  result.files.push_back(csv_file("backends", table));
  result.files.push_back(json_file("backends", {{"experiment", "backends"},
                                                {"scene", context.scene.name},
                                                {"faults", faults},
                                                {"frames", table}}));
  result.summary =
      aligned_text(table, kBrief) + opened +
      (faults == 0 ? "all differences are those between exact areas and samples\n"
                   : fmt::format("{} pictures differ by more than areas and samples do\n", faults));
  return result;
}

}  // namespace

extern const Experiment entry = {
    "backends",
    "Do GL pictures differ from exact ones by more than their samples allow?",
    &run,
    {.field = true, .glass = true}};  // what bends or splits rays is drawn like all else

}  // namespace flatray::backends_experiment
