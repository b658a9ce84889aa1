#include "study/experiment.h"

#include <fmt/core.h>

#include "app/experiments/experiment_monitor.h"
#include "app/experiments/experiment_sweep.h"
#include "app/files/result_files.h"
#include "app/files/scene_input.h"
#include "app/help/version.h"
#include "app/interrupt.h"
#include "app/options/option_values.h"
#include "app/report/report.h"
#include "app/verb.h"
#include "base/number_text.h"

namespace flatray::verbs {
namespace {

constexpr auto kOptions = with_scene_options(
    {{"output", 'o', "FOLDER", "where its files go (default out/NAME)"},
     {"count", '\0', "N", "how many to try (default 1000000)"},
     {"bounces", 'n', "N", "of one orbit (each experiment has its own default)"},
     {"apart", '\0', "D", "of orbits that start near each other (default 1e-9)"},
     {"map", '\0', "position|angle",
      "what the pixels of a picture stand for, instead of the usual"},
     {"starts", '\0', "random|quasi",
      "how starts that are drawn are spread: each by itself (usual), or evenly together, which has "
      "a smaller error where orbits are short"},
     {"sweep", '\0', "KEY=A..B:STEP",
      "run once for each value of a key of the scene, also KEY=V,V,..."},
     {"resume", '\0', "", "keep what is done, and go on from what was kept", OptionKind::flag},
     {"seed", '\0', "N", "seed of all draws (default 1)"},
     kForceOption,
     kThreadsOption,
     kJsonOption});

std::vector<std::string> experiment_names() { return names_of(flatray::experiments()); }

Result<const Experiment*> find_experiment(const std::string& name) {
  for (const Experiment* one : flatray::experiments())
    if (name == one->name) return one;
  return unknown_name(named_place("experiment"), "experiment", name, experiment_names());
}

// Options that would change nothing. What the environment says is for all commands.
Result<void> expect_used(const Arguments& arguments, const Experiment& experiment) {
  const ExperimentUses& uses = experiment.uses;
  const std::pair<const char*, bool> options[] = {
      {"count", uses.count}, {"bounces", uses.bounces}, {"apart", uses.apart},  {"map", uses.map},
      {"seed", uses.seed},   {"starts", uses.starts},   {"resume", uses.resume}};
  std::string used;
  for (const auto& [name, is_used] : options)
    if (is_used) used += (used.empty() ? "--" : ", --") + std::string(name);
  Diagnostics problems;
  for (const auto& [name, is_used] : options) {
    const auto given = arguments.given().find(name);
    if (is_used || given == arguments.given().end() || !given->second.origin.starts_with("--"))
      continue;
    problems.push_back({arguments.where(name),
                        fmt::format("is not an option of experiment {}", experiment.name),
                        used.empty() ? "it takes a scene and no such option" : "it takes " + used});
    problems.back().trouble = Trouble::usage;
  }
  if (problems.empty()) return {};
  return tl::unexpected(std::move(problems));
}

std::filesystem::path folder_of(const Arguments& arguments, const Experiment& experiment) {
  return arguments.text("output").value_or(fmt::format("out/{}", experiment.name));
}

// What a run is asked for beside its scene.
struct Request {
  std::uint64_t seed = 1, count = 0;
  std::optional<std::uint64_t> bounces;
  double apart = 0;
  PixelMap map = PixelMap::usual;
  Starts starts = Starts::random;
  unsigned threads = 1;
};

Result<Request> read_request(const Arguments& arguments) {
  constexpr std::uint64_t kMostTries = std::uint64_t{1} << 40;
  Request request;
  const auto seeded = arguments.whole("seed", 1, 0, ~std::uint64_t{0});
  if (!seeded) return tl::unexpected(seeded.error());
  const auto count = arguments.whole("count", 1'000'000, 1, kMostTries);
  if (!count) return tl::unexpected(count.error());
  const auto bounces = arguments.whole("bounces", 0, 1, kMostTries);
  if (!bounces) return tl::unexpected(bounces.error());
  const auto width = threads(arguments);
  if (!width) return tl::unexpected(width.error());
  const auto apart = parse_number(arguments.text("apart").value_or("1e-9"));
  if (!apart || !(*apart > 0 && *apart < 1))
    return usage_error(arguments.where("apart"), "is not a distance between 0 and 1", "say 1e-9");
  const auto map = arguments.one_of("map", {"usual", "position", "angle"});
  if (!map) return tl::unexpected(map.error());
  request.map = *map == "position" ? PixelMap::position
                : *map == "angle"  ? PixelMap::angle
                                   : PixelMap::usual;
  const auto starts = arguments.one_of("starts", {"random", "quasi"});
  if (!starts) return tl::unexpected(starts.error());
  request.starts = *starts == "quasi" ? Starts::quasi : Starts::random;
  request.seed = *seeded;
  request.count = *count;
  if (arguments.has("bounces")) request.bounces = *bounces;
  request.apart = *apart;
  request.threads = *width;
  return request;
}

// All that the numbers of a block depend on.
Fields setting_of(const Experiment& experiment, const Scene& scene, const Request& request) {
  return {{"experiment", experiment.name},
          {"scene", fmt::format("{:016x}", scene.hash)},
          {"seed", request.seed},
          {"count", request.count},
          {"bounces", request.bounces.value_or(0)},
          {"apart", request.apart},
          {"map", static_cast<int>(request.map)},
          {"starts", static_cast<int>(request.starts)},
          {"version", kVersion}};
}

using Monitors = std::vector<std::unique_ptr<ExperimentMonitor>>;

Result<ExperimentResult> measure(const Arguments& arguments, const Experiment& experiment,
                                 const std::vector<Override>& more,
                                 const std::filesystem::path& folder, Monitors& monitors) {
  const auto request = read_request(arguments);
  if (!request) return tl::unexpected(request.error());
  const auto loaded = load_input(arguments, arguments.operands()[1], more);
  if (!loaded) return tl::unexpected(loaded.error());
  report_warnings(loaded->warnings, arguments);
  std::optional<std::filesystem::path> kept_in;
  if (arguments.has("resume")) kept_in = folder / (std::string(experiment.name) + ".blocks");
  auto monitor = ExperimentMonitor::open(kept_in, setting_of(experiment, loaded->scene, *request),
                                         Outputs(arguments));
  if (!monitor) return fail(std::move(monitor));
  monitors.push_back(std::move(*monitor));
  auto result = experiment.run({.scene = loaded->scene,
                                .seed = request->seed,
                                .count = request->count,
                                .threads = request->threads,
                                .bounces = request->bounces,
                                .apart = request->apart,
                                .map = request->map,
                                .monitor = monitors.back().get(),
                                .starts = request->starts});
  if (auto finished = monitors.back()->finish(); !finished) return fail(std::move(finished));
  return result;
}

Result<ExperimentResult> measure_all(const Arguments& arguments, const Experiment& experiment,
                                     const std::filesystem::path& folder, Monitors& monitors) {
  if (!arguments.has("sweep")) return measure(arguments, experiment, {}, folder, monitors);
  const auto sweep = parse_sweep(*arguments.text("sweep"), arguments.where("sweep"));
  if (!sweep) return tl::unexpected(sweep.error());
  SweepResults results(experiment.name, *sweep);
  for (const std::string& value : sweep->values) {
    const auto changed = parse_overrides({sweep->key + "=" + value}, arguments.where("sweep"));
    if (!changed) return tl::unexpected(changed.error());
    auto one = measure(arguments, experiment, *changed, folder / value, monitors);
    if (!one) return one;
    results.add(value, *one);
  }
  return std::move(results).result();
}

constexpr const char* kKept = "blocks done are kept where --resume was given";

int report_interrupted(const Diagnostics& why) {
  report_note(fmt::format("flatray: {}, {}; {}", interruption(), why.front().message, kKept));
  return interrupted_code();
}

// What the results in a folder depend on, as it is asked for.
Fields asked_of(const Arguments& arguments) {
  Fields fields{{"scene", arguments.operands()[1]}};
  for (const char* option :
       {"define", "seed", "count", "bounces", "apart", "map", "starts", "sweep"})
    if (arguments.has(option)) fields.emplace_back(option, comma_list(arguments.list(option)));
  return fields;
}

// A folder that goes again where nothing has been written into it.
class MadeFolder {
 public:
  explicit MadeFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}
  MadeFolder(const MadeFolder&) = delete;
  MadeFolder& operator=(const MadeFolder&) = delete;
  ~MadeFolder() {
    std::error_code error;
    if (is_new_ && std::filesystem::remove(folder_, error) && parent_is_new_)
      std::filesystem::remove(folder_.parent_path(), error);
  }

 private:
  std::filesystem::path folder_;
  bool is_new_ = !std::filesystem::exists(folder_);
  bool parent_is_new_ = is_new_ && !std::filesystem::exists(folder_.parent_path());
};

Result<VerbOutput> run(const Arguments& arguments) {
  const auto experiment = find_experiment(arguments.operands()[0]);
  if (!experiment) return tl::unexpected(experiment.error());
  if (auto used = expect_used(arguments, **experiment); !used) return fail(std::move(used));
  const std::filesystem::path folder = folder_of(arguments, **experiment);
  // Two that are at work in one folder, and not of the same, would replace each other's results.
  const MadeFolder made(folder);
  const auto claim = Claim::take(folder, (*experiment)->name, json_text(asked_of(arguments)),
                                 arguments.has("force"));
  if (!claim) return tl::unexpected(claim.error());
  Monitors monitors;
  if ((*experiment)->name == std::string_view("backends")) expect_crashes_of_gl();
  const auto result = measure_all(arguments, **experiment, folder, monitors);
  if (!result && interrupted()) return VerbOutput{.exit_code = report_interrupted(result.error())};
  if (!result) return tl::unexpected(result.error());
  if (auto held = claim->expect_held(); !held) return fail(std::move(held));
  auto files = write_files(*result, folder, Outputs(arguments));
  if (!files) return fail(std::move(files));
  for (const auto& monitor : monitors)
    if (auto forgotten = monitor->forget(); !forgotten) return fail(std::move(forgotten));
  return VerbOutput{.text = {result->summary},
                    .results = Fields{{"experiment", (*experiment)->name},
                                      {"question", (*experiment)->question},
                                      {"holds", result->holds},
                                      {"summary", result->summary},
                                      {"files", std::move(*files)}},
                    .exit_code = result->holds ? 0 : 1};
}

}  // namespace

extern const Verb experiment = {
    "experiment",
    "NAME SCENE",
    "measure something of a scene and compare it with what must come out",
    2,
    2,
    kOptions,
    "  flatray experiment mean-free-path scenes/chamber/sinai.toml -o out\n"
    "  flatray experiment lyapunov scenes/chamber/sinai.toml "
    "--sweep chamber.0.pillars.0.shape.circle.radius=0.1..0.4:0.05\n"
    "  flatray experiment mean-free-path scenes/chamber/hall.toml --bounces 1 --starts quasi\n"
    "  flatray experiment markov scenes/markov/runner.toml --seed 2\n",
    "nothing measured",
    &run,
    &experiment_names,
    kKept};

}  // namespace flatray::verbs
