#include "study/experiment.h"

#include <fmt/core.h>

#include <chrono>

#include "app/option_values.h"
#include "app/report.h"
#include "app/scene_input.h"
#include "app/verb.h"
#include "base/file.h"

namespace flatray::verbs {
namespace {

constexpr auto kOptions =
    with_scene_options({{"output", 'o', "FOLDER", "where its files go (default out/NAME)"},
                        {"count", '\0', "N", "how many to try (default 1000000)"},
                        {"seed", '\0', "N", "seed of all draws (default 1)"},
                        kThreadsOption,
                        kJsonOption});

std::vector<std::string> experiment_names() { return names_of(flatray::experiments()); }

Result<const Experiment*> find_experiment(const std::string& name) {
  for (const Experiment* one : flatray::experiments())
    if (name == one->name) return one;
  return unknown_name(named_place("experiment"), "experiment", name, experiment_names());
}

Result<Values> write_files(const ExperimentResult& result, const std::filesystem::path& folder) {
  Values names;
  for (const ExperimentResult::File& file : result.files) {
    if (auto written = write_file(folder / file.name, file.content); !written)
      return fail(std::move(written));
    names.emplace_back((folder / file.name).string());
  }
  return names;
}

Result<ExperimentResult> measure(const Arguments& arguments, const Experiment& experiment) {
  constexpr std::uint64_t kMostTries = std::uint64_t{1} << 32;
  const auto seeded = arguments.whole("seed", 1, 0, ~std::uint64_t{0});
  if (!seeded) return tl::unexpected(seeded.error());
  const auto count = arguments.whole("count", 1'000'000, 1, kMostTries);
  if (!count) return tl::unexpected(count.error());
  const auto width = threads(arguments);
  if (!width) return tl::unexpected(width.error());
  const auto loaded = load_input(arguments, arguments.operands()[1]);
  if (!loaded) return tl::unexpected(loaded.error());
  report_warnings(loaded->warnings, arguments);
  return experiment.run(
      {.scene = loaded->scene, .seed = *seeded, .count = *count, .threads = *width});
}

Result<VerbOutput> run(const Arguments& arguments) {
  const auto start = std::chrono::steady_clock::now();
  const auto experiment = find_experiment(arguments.operands()[0]);
  if (!experiment) return tl::unexpected(experiment.error());
  const auto result = measure(arguments, **experiment);
  if (!result) return tl::unexpected(result.error());
  const auto folder = arguments.text("output").value_or(fmt::format("out/{}", (*experiment)->name));
  auto files = write_files(*result, folder);
  if (!files) return fail(std::move(files));
  const int code = result->holds ? 0 : 1;
  if (!arguments.has("json")) return VerbOutput{result->summary, code};
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  Fields fields{{"experiment", (*experiment)->name},
                {"question", (*experiment)->question},
                {"holds", result->holds},
                {"summary", result->summary},
                {"files", std::move(*files)}};
  return VerbOutput{json_report("experiment", arguments, std::move(fields), time.count()), code};
}

}  // namespace

extern const Verb experiment = {
    "experiment",
    "NAME SCENE",
    "measure something of a scene and compare it with what must come out",
    2,
    2,
    kOptions,
    "  flatray experiment markov scenes/markov/runner.toml --seed 2\n",
    "nothing measured",
    &run,
    &experiment_names};

}  // namespace flatray::verbs
