#include "study/accuracy/accuracy.h"

#include <fmt/core.h>

#include <algorithm>

#include "app/files/result_files.h"
#include "app/files/scene_input.h"
#include "app/frames/profile.h"
#include "app/interrupt.h"
#include "app/options/option_values.h"
#include "app/report/report.h"
#include "app/verb.h"
#include "study/accuracy/accuracy_report.h"

namespace flatray::verbs {
namespace {

std::vector<std::string> choice_names() { return names_of(flatray::choices()); }

constexpr auto kOptions = with_scene_options(
    {{"output", 'o', "FOLDER", "where its files go (default out/accuracy)"},
     {"budget", '\0', "SECONDS",
      "of processor time for everything, the references included (default 60s)"},
     {"choice", '\0', "NAME,NAME", "only these choices", OptionKind::text, &choice_names},
     {"profile", '\0', "OUT.json", "also write what flatray render --profile chooses from"},
     {"seed", '\0', "N", "seed of all draws (default 1)"},
     kForceOption,
     kThreadsOption,
     kJsonOption});

constexpr double kMostSeconds = 1e6;

Result<double> read_budget(const Arguments& arguments) {
  const auto seconds = parse_seconds(arguments.text("budget").value_or("60s"));
  if (!seconds || !(*seconds > 0))
    return usage_error(arguments.where("budget"), "is not a time above 0", "say 60s");
  if (*seconds > kMostSeconds)
    return usage_error(arguments.where("budget"), "is too long a time",
                       fmt::format("say {}s at most", kMostSeconds));
  return *seconds;
}

Result<VerbOutput> run(const Arguments& arguments) {
  const auto names = chosen_names(arguments, "choice", "choice", choice_names());
  if (!names) return tl::unexpected(names.error());
  const auto budget = read_budget(arguments);
  if (!budget) return tl::unexpected(budget.error());
  const auto seed = arguments.whole("seed", 1, 0, ~std::uint64_t{0});
  if (!seed) return tl::unexpected(seed.error());
  const auto width = threads(arguments);
  if (!width) return tl::unexpected(width.error());
  const auto loaded = load_input(arguments, arguments.operands()[0]);
  if (!loaded) return tl::unexpected(loaded.error());
  report_warnings(loaded->warnings, arguments);
  if (arguments.has("profile") &&
      std::find(names->begin(), names->end(), "coverage") == names->end())
    return usage_error(arguments.where("profile"), "holds coverages, which --choice leaves out",
                       "add coverage to --choice");
  // Before anything is measured, as nothing is measured for a file that cannot be written.
  const Outputs outputs(arguments);
  const auto profile = arguments.text("profile");
  if (profile)
    if (auto allowed = outputs.allow(*profile, profile_text(loaded->scene, {})); !allowed)
      return fail(std::move(allowed));
  std::vector<const Choice*> chosen;
  for (const Choice* choice : flatray::choices())
    if (std::find(names->begin(), names->end(), choice->name) != names->end())
      chosen.push_back(choice);
  expect_crashes_of_gl();  // where it is one of the choices
  const std::vector<ChoiceReport> reports =
      measure_choices(chosen, {loaded->scene, *seed, *width, *budget});
  const ExperimentResult result = accuracy_report(
      loaded->scene.name, reports, picture_of({loaded->scene, *seed, *width, *budget}));
  auto files = write_files(result, arguments.text("output").value_or("out/accuracy"), outputs);
  if (!files) return fail(std::move(files));
  if (profile) {
    if (auto written = outputs.write(*profile, profile_text(loaded->scene, reports)); !written)
      return fail(std::move(written));
    files->emplace_back(*profile);
  }
  return VerbOutput{.text = {result.summary},
                    .results = Fields{{"summary", result.summary}, {"files", std::move(*files)}}};
}

}  // namespace

extern const Verb accuracy = {
    "accuracy",
    "SCENE",
    "measure error against run time of every choice a scene has",
    1,
    1,
    kOptions,
    "  flatray accuracy scenes/tutorial/11_journey.toml -o out/accuracy\n"
    "  flatray accuracy scenes/chamber/sinai.toml --choice samples,precision --budget 10s\n"
    "  flatray accuracy scenes/tutorial/11_journey.toml --choice coverage --profile "
    "journey.profile\n",
    "nothing measured",
    &run};

}  // namespace flatray::verbs
