#include "study/accuracy/accuracy.h"

#include <fmt/core.h>

#include <algorithm>

#include "app/files/result_files.h"
#include "app/files/scene_input.h"
#include "app/frames/profile.h"
#include "app/interrupt.h"
#include "app/options/option_values.h"
#include "app/verb.h"
#include "study/accuracy/accuracy_report.h"

namespace flatray::accuracy_verb {
namespace {

std::vector<std::string> choice_names() { return names_of(flatray::choices()); }

struct Options : Arguments {
  SceneOptions scene;
  std::string output = "out/accuracy", profile;
  double budget = 60;
  std::vector<std::string> choices = choice_names();
  std::uint64_t seed = 1;

  bool chooses(std::string_view name) const {
    return std::ranges::find(choices, name) != choices.end();
  }

  void rows(OptionTable& row) {
    row("-o, --output FOLDER", "where its files go", output);
    row("--budget SECONDS",
        "of processor time for everything, the references included; one setting is measured "
        "whatever it takes",
        budget, time_up_to(1e6));
    row("--choice NAME,NAME", "only these choices", choices, names_among("choice", choices),
        &choice_names);
    row("--profile OUT.json", "also write what flatray render --profile chooses from", profile);
    scene.row_of_seed(row, seed);
    row(kForceRow);
    row_of_threads(row, scene.limits.threads);
    row(kJsonRow);
    scene.rows(row);
    if (!profile.empty() && !chooses("coverage"))
      row.problem("profile", "holds coverages, which --choice leaves out",
                  "add coverage to --choice");
  }
};

// What its files begin with.
ExperimentResult files_begun(const std::string& scene, std::span<const Choice* const> chosen) {
  ExperimentResult begun = accuracy_report(scene, {});
  for (const Choice* choice : chosen) begun.files.push_back({plot_name(choice->name), "<?xml"});
  return begun;
}

Result<VerbOutput> run(const Options& options) {
  FLATRAY_TRY(loaded, load_input(options.scene, options.operands()[0]));
  report_warnings(loaded->warnings, options);
  // Before anything is measured, as nothing is measured for a file that cannot be written.
  const Outputs outputs(options);
  if (!options.profile.empty()) {
    FLATRAY_TRY(allowed, outputs.allow(options.profile, profile_text(loaded->scene, {})));
  }
  std::vector<const Choice*> chosen;
  for (const Choice* choice : flatray::choices())
    if (options.chooses(choice->name)) chosen.push_back(choice);
  Diagnostics left_out;
  for (const Choice* choice : chosen)
    if (const std::string why = choice->left_out(loaded->scene); !why.empty())
      left_out.push_back({named_place(options.operands()[0]),
                          fmt::format("{} cannot be measured: {}", choice->name, why), ""});
  if (left_out.size() == chosen.size()) return tl::unexpected(std::move(left_out));
  FLATRAY_TRY(begun, allow_files(files_begun(loaded->scene.name, chosen), options.output, outputs));
  expect_crashes_of_gl();  // where it is one of the choices
  const AccuracyContext context{loaded->scene, options.seed, options.scene.limits.threads,
                                options.budget};
  const std::vector<ChoiceReport> reports = measure_choices(chosen, context);
  const ExperimentResult result = accuracy_report(loaded->scene.name, reports, picture_of(context));
  FLATRAY_TRY(files, write_files(result, options.output, outputs));
  if (!options.profile.empty()) {
    FLATRAY_TRY(written, outputs.write(options.profile, profile_text(loaded->scene, reports)));
    files->emplace_back(options.profile);
  }
  Fields results = accuracy_fields(loaded->scene.name, reports);
  results.insert(results.end(), {{"summary", result.summary}, {"files", std::move(*files)}});
  return VerbOutput{.text = {result.summary}, .results = std::move(results)};
}

}  // namespace

extern const Verb entry = {
    "accuracy",
    "SCENE",
    "measure error against run time of every choice a scene has",
    kCommand<Options, &run>,
    "  flatray accuracy scenes/tutorial/11_journey.toml -o out/accuracy\n"
    "  flatray accuracy scenes/chamber/sinai.toml --choice samples,precision --budget 10s\n"
    "  flatray accuracy scenes/tutorial/11_journey.toml --choice coverage --profile "
    "journey.profile\n",
    "nothing measured"};

}  // namespace flatray::accuracy_verb
