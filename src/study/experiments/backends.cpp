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

class Study {
 public:
  explicit Study(const ExperimentContext& context)
      : context_(context), plan_(make_plan(context.scene, false)) {}

  Result<void> run(unsigned samples) {
    const Backend* backend = entry_named(flatray::backends(), "gl");
    if (backend == nullptr)
      return fail({}, "this build has no GL back end", "", Trouble::unavailable);
    FLATRAY_TRY(renderer, backend->open({context_.threads, samples}));
    opened_.push_back((*renderer)->description());
    const unsigned last = context_.scene.frames;
    FLATRAY_TRY(timeline, make_timeline(context_.scene, context_.scene.seed, last));
    for (const unsigned frame : std::set<unsigned>{1, (last + 1) / 2, last}) {
      FLATRAY_TRY(list, draw_list(plan_, *timeline, frame));
      if (auto added = add(**renderer, samples, *list, frame); !added) return added;
    }
    return {};
  }

  ExperimentResult result() && {
    result_.holds = faults_ == 0;
    result_.summary = aligned_text(table_, kBrief);
    result_.files.push_back(csv_file("backends", table_));
    result_.files.push_back(json_file("backends", {{"experiment", "backends"},
                                                   {"scene", context_.scene.name},
                                                   {"faults", faults_},
                                                   {"frames", table_}}));
    for (const std::string& one : opened_) result_.summary += one + "\n";
    result_.summary +=
        faults_ == 0
            ? "all differences are those between exact areas and samples\n"
            : fmt::format("{} pictures differ by more than areas and samples do\n", faults_);
    return std::move(result_);
  }

 private:
  Result<void> add(const Renderer& renderer, unsigned samples, const DrawList& list,
                   unsigned frame) {
    Image drawn;
    if (auto done = renderer.draw(list, {std::nullopt, 1}, drawn); !done) return done;
    const Image exact = render_image(list, {std::nullopt, context_.threads});
    const Difference difference = compare(drawn, exact).value();
    const PointSampled sampled =
        point_sampled(list, sample_places(list.coverage, samples), context_.threads);
    const DifferenceCauses why = difference_causes(drawn, exact, sampled, edge_pixels(list));
    table_.add({context_.scene.name, std::uint64_t{frame}, std::uint64_t{samples},
                static_cast<std::uint64_t>(difference.worst), difference.mean,
                static_cast<std::uint64_t>(why.flat_worst), why.edge, why.sampled, why.rounded,
                why.unexplained});
    if (!why.coverage_alone()) ++faults_;
    return {};
  }

  const ExperimentContext& context_;
  const RenderPlan plan_;
  Table table_{{"scene", "frame", "samples", "worst", "mean", "flat_worst", "edge_pixels",
                "sampled", "rounded", "unexplained"}};
  std::vector<std::string> opened_;
  std::uint64_t faults_ = 0;
  ExperimentResult result_;
};

Result<ExperimentResult> run(const ExperimentContext& context) {
  Study study(context);
  for (const unsigned samples : {4U, 16U})
    if (auto done = study.run(samples); !done) return fail(std::move(done));
  return std::move(study).result();
}

}  // namespace

extern const Experiment entry = {
    "backends",
    "Do GL pictures differ from exact ones by more than their samples allow?",
    &run,
    {.field = true, .glass = true}};  // what bends or splits rays is drawn like all else

}  // namespace flatray::backends_experiment
