#include "study/experiment.h"

#include <fmt/core.h>

#include <algorithm>

#include "app/experiments/experiment_monitor.h"
#include "app/experiments/experiment_sweep.h"
#include "app/files/hdf5_file.h"
#include "app/files/result_files.h"
#include "app/files/scene_input.h"
#include "app/help/version.h"
#include "app/interrupt.h"
#include "app/verb.h"
#include "base/number_text.h"
#include "precise/certified_orbit.h"

namespace flatray::experiment_verb {
namespace {

std::vector<std::string> experiment_names() { return names_of(flatray::experiments()); }

constexpr Word<PixelMap> kMaps[] = {
    {"usual", PixelMap::usual}, {"position", PixelMap::position}, {"angle", PixelMap::angle}};
constexpr Word<OrbitPrecision> kPrecisions[] = {{"fast", OrbitPrecision::fast},
                                                {"exact", OrbitPrecision::exact},
                                                {"certified", OrbitPrecision::certified}};
constexpr Word<Starts> kStarts[] = {
    {"random", Starts::random}, {"quasi", Starts::quasi}, {"conditional", Starts::conditional}};

Result<double> parse_apart(const std::string& text, const Place& where) {
  const auto apart = parse_number(text);
  if (apart && *apart > 0 && *apart < 1) return *apart;
  return usage_error(where, "is not a distance between 0 and 1", "say 1e-9");
}

struct Options : Arguments {
  SceneOptions scene;
  const Experiment* experiment = nullptr;
  std::string output;
  std::uint64_t seed = 1, count = 1'000'000;
  std::optional<std::uint64_t> bounces, symbols;
  double apart = 1e-9;
  PixelMap map = PixelMap::usual;
  Starts starts = Starts::random;
  OrbitPrecision precision = OrbitPrecision::exact;
  std::optional<Sweep> sweep;
  bool resume = false, hdf5 = false;

  std::filesystem::path folder() const {
    return output.empty() ? fmt::format("out/{}", experiment->name) : output;
  }
  bool sweeps_seed() const { return sweep && sweep->key == "seed"; }

  void rows(OptionTable& row) {
    constexpr std::uint64_t kMostTries = std::uint64_t{1} << 40, kMostSymbols = 32;
    row("-o, --output FOLDER", "where its files go (default out/NAME)", output);
    row("--count N", "how many to try", count, 1, kMostTries);
    row("-n, --bounces N", "of one orbit; each experiment has its own default", bounces, 1,
        kMostTries);
    row("--apart D", "of orbits that start near each other", apart, &parse_apart);
    row("--map", "what the pixels of a picture stand for", map, kMaps);
    row("--starts",
        "how starts that are drawn are spread: each by itself; evenly together, which has a "
        "smaller error where orbits are short; as what is left of an open room after long (escape)",
        starts, kStarts);
    row("--symbols N", "bounces of the longest periodic orbit (default 6)", symbols, 1,
        kMostSymbols);
    row("--precision",
        "how orbits of means are followed: fast in doubles, with some of them audited; "
        "exact, wall by wall; certified, bounce by bounce",
        precision, kPrecisions);
    row("--sweep KEY=A..B:STEP",
        "run once for each value of a key of the scene, also KEY=V,V,...; seed is that of all "
        "draws",
        sweep, &parse_sweep);
    row("--hdf5", "write its numbers as NAME.h5, too, by libhdf5", hdf5);
    row("--resume", "keep what is done, and go on from what was kept", resume);
    scene.row_of_seed(row, seed);
    row(kForceRow);
    row_of_threads(row, scene.limits.threads);
    row(kJsonRow);
    scene.rows(row);
    if (!row.operand(0).empty()) expect_used(row);
  }

 private:
  // Options that would change nothing. What the environment says is for all commands.
  void expect_used(OptionTable& row) {
    const auto found = entry_called("experiment", flatray::experiments())(
        row.operand(0), named_place("experiment"));
    if (!found) return row.keep(found.error());
    experiment = *found;
    const ExperimentUses& uses = experiment->uses;
    const std::pair<const char*, bool> all[] = {
        {"count", uses.count},   {"bounces", uses.bounces},     {"apart", uses.apart},
        {"map", uses.map},       {"seed", uses.seed},           {"starts", uses.starts},
        {"resume", uses.resume}, {"precision", uses.precision}, {"symbols", uses.symbols}};
    std::string used;
    for (const auto& [name, is_used] : all)
      if (is_used) used += (used.empty() ? "--" : ", --") + std::string(name);
    for (const auto& [name, is_used] : all)
      if (!is_used && is_asked(name))
        row.problem(name, fmt::format("is not an option of experiment {}", experiment->name),
                    used.empty() ? "it takes a scene and no such option" : "it takes " + used);
    if (starts == Starts::conditional && uses.starts && !uses.conditional)
      row.problem("starts", fmt::format("experiment {} knows none that are left", experiment->name),
                  "say random or quasi; escape takes conditional ones");
    if (sweeps_seed() && is_asked("seed"))
      row.problem("sweep", "has the seed, which --seed has, too", "say one of them");
  }
};

// All that the numbers of a block depend on.
Fields setting_of(const Options& options, const Scene& scene, std::uint64_t seed) {
  return {{"experiment", options.experiment->name},
          {"scene", fmt::format("{:016x}", scene.hash)},
          {"seed", seed},
          {"count", options.count},
          {"bounces", options.bounces.value_or(0)},
          {"apart", options.apart},
          {"map", static_cast<int>(options.map)},
          {"starts", static_cast<int>(options.starts)},
          {"precision", static_cast<int>(options.precision)},
          {"version", kVersion}};
}

using Monitors = std::vector<std::unique_ptr<ExperimentMonitor>>;

Result<ExperimentResult> measure(const Options& options, const std::vector<Override>& more,
                                 const std::filesystem::path& folder, Monitors& monitors) {
  SceneOptions with = options.scene;
  if (options.sweeps_seed()) with.seed.reset();
  FLATRAY_TRY(loaded, load_input(with, options.operands()[1], more));
  report_warnings(loaded->warnings, options);
  const bool certified = options.precision == OrbitPrecision::certified;
  const std::string experiment = fmt::format("experiment {}", options.experiment->name),
                    precision = "--precision certified";
  if (!options.experiment->uses.field) {
    FLATRAY_TRY(straight, expect_no_field(loaded->scene, experiment));
  }
  if (!options.experiment->uses.glass || certified) {
    FLATRAY_TRY(unsplit, expect_no_glass(loaded->scene, certified ? precision : experiment));
  }
  if (certified) {
    FLATRAY_TRY(straight, expect_no_field(loaded->scene, precision));
  }
  std::optional<std::filesystem::path> kept_in;
  if (options.resume) kept_in = folder / (std::string(options.experiment->name) + ".blocks");
  const std::uint64_t seed = options.sweeps_seed() ? loaded->scene.seed : options.seed;
  FLATRAY_TRY(monitor, ExperimentMonitor::open(kept_in, setting_of(options, loaded->scene, seed),
                                               Outputs(options)));
  monitors.push_back(std::move(*monitor));
  auto result = options.experiment->run({.scene = loaded->scene,
                                         .seed = seed,
                                         .count = options.count,
                                         .threads = options.scene.limits.threads,
                                         .bounces = options.bounces,
                                         .apart = options.apart,
                                         .map = options.map,
                                         .monitor = monitors.back().get(),
                                         .starts = options.starts,
                                         .symbols = options.symbols,
                                         .precision = options.precision});
  if (auto finished = monitors.back()->finish(); !finished) return fail(std::move(finished));
  if (result && interrupted() &&
      options.experiment->uses.resume)  // an audit may have been cut short
    return fail(loaded->scene.where, "stopped after its last block");
  return result;
}

Result<ExperimentResult> measure_all(const Options& options, Monitors& monitors) {
  const std::filesystem::path folder = options.folder();
  if (!options.sweep) return measure(options, {}, folder, monitors);
  SweepResults results(options.experiment->name, *options.sweep);
  for (std::size_t i = 0; i < options.sweep->values.size() && !interrupted(); ++i) {
    const std::string& value = options.sweep->values[i];
    const std::vector<Override> changed{{options.sweep->key, value, options.where("sweep")}};
    auto one = measure(options, changed, folder / std::to_string(i + 1), monitors);
    if (!one && interrupted() && i > 0) break;  // those before are told
    if (!one) {
      if (!interrupted())
        for (Diagnostic& problem : one.error())
          problem.message += fmt::format(" (--sweep {}={})", options.sweep->key, value);
      return one;
    }
    if (one->measures.empty())
      return usage_error(named_place("--sweep"),
                         fmt::format("experiment {} has no numbers that could stand side by side",
                                     options.experiment->name),
                         "run it once for each value");
    results.add(value, *one);
  }
  return std::move(results).result();
}

constexpr const char* kKept = "blocks done are kept where --resume was given";

int report_interrupted(const Options& options, const Diagnostics& why) {
  const std::string kept = options.experiment->uses.resume ? fmt::format("; {}", kKept) : "";
  report_note(fmt::format("flatray: {}, {}{}", interruption(), why.front().message, kept));
  return interrupted_code();
}

// What the results in a folder depend on, as it is asked for.
Fields asked_of(const Arguments& options) {
  Fields fields{{"scene", options.operands()[1]}};
  for (const char* option : {"define", "seed", "count", "bounces", "apart", "map", "starts",
                             "precision", "symbols", "sweep"})
    if (options.has(option)) fields.emplace_back(option, comma_list(options.list(option)));
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

Result<VerbOutput> run(const Options& options) {
  const Experiment& experiment = *options.experiment;
  if (options.precision == OrbitPrecision::certified)
    if (auto able = can_certify(); !able) return fail(std::move(able));
  if (options.hdf5)
    if (auto able = can_write_hdf5(); !able) return fail(std::move(able));
  // Two that are at work in one folder, and not of the same, would replace each other's results.
  const MadeFolder made(options.folder());
  FLATRAY_TRY(claim, Claim::take(options.folder(), experiment.name, json_text(asked_of(options)),
                                 options.has("force")));
  Monitors monitors;
  if (experiment.name == std::string_view("backends")) expect_crashes_of_gl();
  auto result = measure_all(options, monitors);
  if (!result && interrupted())
    return VerbOutput{.exit_code = report_interrupted(options, result.error())};
  if (!result) return tl::unexpected(result.error());
  if (auto held = claim->expect_held(); !held) return fail(std::move(held));
  if (options.hdf5 && result->measures.empty())
    report_warnings(
        {{options.where("hdf5"),
          "no .h5 is written: what was asked has tables alone, and they are in .csv", ""}},
        options);
  else if (options.hdf5) {
    std::string name = experiment.name;
    std::replace(name.begin(), name.end(), '-', '_');  // as files beside it are called
    FLATRAY_TRY(file, hdf5_file(name,
                                {{"question", experiment.question},
                                 {"asked", json_text(asked_of(options))},
                                 {"version", kVersion}},
                                *result));
    result->files.push_back(std::move(*file));
  }
  FLATRAY_TRY(files, write_files(*result, options.folder(), Outputs(options)));
  const bool stopped = interrupted();
  if (stopped)
    report_note(fmt::format("flatray: {}; what was done by then is written", interruption()));
  else
    for (const auto& monitor : monitors)
      if (auto forgotten = monitor->forget(); !forgotten) return fail(std::move(forgotten));
  return VerbOutput{.text = {result->summary},
                    .results = Fields{{"experiment", experiment.name},
                                      {"question", experiment.question},
                                      {"holds", result->holds},
                                      {"measures", result->table},
                                      {"summary", result->summary},
                                      {"files", std::move(*files)}},
                    .exit_code = stopped         ? interrupted_code()
                                 : result->holds ? 0
                                                 : 1};
}

}  // namespace

extern const Verb entry = {
    "experiment",
    "NAME SCENE",
    "measure something of a scene and compare it with what must come out",
    kCommand<Options, &run>,
    "  flatray experiment mean-free-path scenes/chamber/sinai.toml -o out\n"
    "  flatray experiment lyapunov scenes/chamber/sinai.toml "
    "--sweep chamber.0.pillars.0.shape.circle.radius=0.1..0.4:0.05\n"
    "  flatray experiment mean-free-path scenes/chamber/hall.toml --bounces 1 --starts quasi\n"
    "  flatray experiment periodic scenes/chamber/three_discs_6.toml --symbols 10\n"
    "  flatray experiment markov scenes/markov/runner.toml --seed 2\n",
    "nothing measured",
    &experiment_names,
    kKept};

}  // namespace flatray::experiment_verb
