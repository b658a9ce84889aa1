#include "study/stability/stability.h"

#include <fmt/core.h>

#include "app/answers/stability_reports.h"
#include "app/files/chunk_log.h"
#include "app/files/scene_input.h"
#include "app/options/tracer_choice.h"
#include "app/verb.h"
#include "base/isa.h"
#include "base/number_text.h"
#include "study/stability/leaks.h"
#include "study/stability/pair_stability.h"

namespace flatray::stability_verb {
namespace {

std::vector<std::string> family_names() { return names_of(oracle::families()); }
std::vector<std::string> place_names() { return names_of(room_places()); }

std::vector<std::string> pair_family_names() { return names_of(pair_families()); }

std::vector<std::string> all_family_names() {
  std::vector<std::string> names = family_names();
  for (std::string& name : pair_family_names()) names.push_back(std::move(name));
  return names;
}

// What is checked where no tracer is named; the others are wrong now and then.
std::vector<const Tracer*> exact_tracers() {
  std::vector<const Tracer*> exact;
  for (const Tracer* tracer : tracers())
    if (tracer->exact) exact.push_back(tracer);
  return exact;
}

// Reads names between commas, each once, each by `usable`.
template <class Usable>
auto each_called(const std::string& text, const Place& where, const char* what,
                 const std::vector<std::string>& known, const Usable& usable)
    -> Result<std::vector<typename decltype(usable(text, where))::value_type>> {
  FLATRAY_TRY(names, chosen_names(text, where, what, known));
  std::vector<typename decltype(usable(text, where))::value_type> chosen;
  for (const std::string& name : *names) {
    FLATRAY_TRY(one, usable(name, where));
    chosen.push_back(*one);
  }
  return chosen;
}

Result<std::vector<const Tracer*>> tracers_called(const std::string& text, const Place& where) {
  return each_called(text, where, "tracer", tracer_names(), &usable_tracer);
}

std::vector<std::string> tier_names() {
  std::vector<std::string> names;
  for (const Isa isa : kAllIsas) names.emplace_back(isa_name(isa));
  return names;
}

Result<std::vector<Isa>> tiers_called(const std::string& text, const Place& where) {
  return each_called(text, where, "instruction-set tier", tier_names(), &usable_isa);
}

struct Options : StabilityRequest {
  std::vector<std::string> families;
  std::uint64_t count = 100'000;
  std::optional<std::uint64_t> pairs;
  bool catalogue = false, sweep = false;
  std::vector<Isa> tiers{active_isa()};

  Options() {
    tracers = exact_tracers();
    places = place_names();
  }

  bool chooses(const std::string& family) const {
    return std::ranges::find(families, family) != families.end();
  }

  void rows(OptionTable& row) {
    constexpr std::uint64_t kMost = std::uint64_t{1} << 40;
    row("--families NAME,NAME",
        "only these families of inputs, as docs/NUMERICS.md names them; with --pairs, families of "
        "pairs",
        &all_family_names);
    row("--tracer NAME,NAME", "these tracers instead of all exact ones", tracers, &tracers_called,
        &tracer_names);
    row("--tiers NAME,NAME",
        "each tracer in these instruction-set tiers, instead of the fastest here; with the "
        "families of rays",
        tiers, &tiers_called, &tier_names);
    row("--count N", "rays of each family for each tracer", count, 1, kMost);
    row("--leaks N", "instead, for each tracer N rays aimed at the vertices of each sealed room",
        leaks, 1, kMost);
    row("--places NAME,NAME", "of --leaks: only where these rooms stand", places,
        names_among("place", places), &place_names);
    row("--pairs N", "instead, N moving pairs of each family against exact contacts", pairs, 1,
        kMost);
    row("--catalogue", "instead, the catalogue of stiff cases by id, for all tracers", catalogue);
    row("--sweep", "instead, scales and offsets from 2^-1000 to 2^1000, for all tracers", sweep);
    scene.row_of_seed(row, seed, ~std::uint64_t{0});
    row("-o, --output FOLDER",
        "where its files go: stability.csv, a row for each 16384 rays or 1024 pairs, or leaks.csv, "
        "for each 1024 rays, from which a run with the same seed goes on; of a scene margins.csv");
    row(kForceRow);
    row_of_threads(row, scene.limits.threads);
    row(kJsonRow);
    const std::size_t before = row.options().size();
    scene.rows(row);
    if (row.operand(0).empty()) refuse(row, std::span(row.options()).subspan(before));
    families = pairs ? pair_family_names() : family_names();
    row.read("families", families, names_among("family", families));
    named = row.has("tracer");
    expect_one_thing(row);
  }

 private:
  // Of a scene where there is none, but for what is of every run.
  static void refuse(OptionTable& row, std::span<const Option> of_scene) {
    for (const Option& one : of_scene)
      if (one.name != "quiet" && row.is_asked(one.name))
        row.problem(one.name, "is about a scene, and none is given",
                    "leave it out, or name a scene");
  }

  // What stands instead of the families: of a scene, --catalogue, --sweep, --leaks and --pairs one
  // at most.
  void expect_one_thing(OptionTable& row) {
    const bool scene_given = !row.operand(0).empty();
    std::string what = scene_given ? "a scene" : "";
    for (const char* other : {"catalogue", "sweep", "leaks", "pairs"}) {
      if (!row.has(other)) continue;
      if (!what.empty())
        return row.problem(other, "does not go with " + what, "leave one of them out");
      what = "--" + std::string(other);
    }
    if (!leaks && row.has("places")) row.problem("places", "is about --leaks", "leave it out");
    if (what.empty()) return;
    for (const char* other : {"families", "count", "tiers"})
      if (row.has(other) && !(pairs && std::string_view(other) == "families"))
        row.problem(other, "is about the families of inputs", "leave it out");
    row.excludes("catalogue", {"seed"});  // its cases are the same for ever
    row.excludes("pairs", {"tracer"});
    if (scene_given && row.has("tracer"))
      row.problem("tracer", "does not go with a scene", "leave it out");
  }
};

using Open = std::vector<std::size_t>;  // numbers of those that are asked about a chunk
template <class T>
std::vector<T> chosen(const std::vector<T>& all, const Open& open) {
  std::vector<T> some(open.size());
  std::ranges::transform(open, some.begin(), [&](std::size_t k) { return all[k]; });
  return some;
}

Result<VerbOutput> run_pairs(const Options& options) {
  const Chunks chunks{*options.pairs, kPairsAChunk};
  FLATRAY_TRY(log, StabilityLog::open(options.text("output"), Outputs(options)));
  Table table({"family", "method", "pairs", "meet", "wrong", "missed", "invented", "other_class",
               "t_not_nearest_or_wide", "t_off", "first_wrong"});
  std::uint64_t wrong = 0;
  for (const PairFamily& family : pair_families()) {
    if (!options.chooses(family.name)) continue;
    std::vector<ChunkLog::Key> keys;
    keys.reserve(family.methods.size());
    for (const auto& method : family.methods)
      keys.push_back(
          {StabilityRows::pairs(family), method, isa_name(active_isa()), options.seed, 0});
    FLATRAY_TRY(done, log->run(keys, chunks, options.scene.limits.threads,
                               [&](std::uint64_t first, std::uint64_t count, const Open& open) {
                                 return chosen(check_pairs(family, options.seed, first, count),
                                               open);
                               }));
    for (std::size_t k = 0; k < keys.size(); ++k) {
      const StabilityTally sum = log->sum(keys[k], chunks.number());
      wrong += sum.wrong + sum.off_by_more;
      table.add({family.name, family.methods[k], sum.rays, sum.hits, sum.wrong, sum.missed,
                 sum.invented, sum.other_wall, sum.not_nearest, sum.off_by_more, sum.first_wrong});
    }
  }
  return stability_output(std::move(table), wrong == 0);
}

// Part of a whole; unknown where a run was stopped before its first chunk.
JsonValue share(std::uint64_t part, std::uint64_t whole) {
  if (whole == 0) return "unknown";
  const double exact = static_cast<double>(part) / static_cast<double>(whole);
  return *parse_number(fmt::format("{:.3g}", exact));
}

// From the quickest chunk to the slowest: how far the mean of one run can be trusted. One chunk
// alone does not tell.
std::string range_of_times(const StabilityLog& log, const ChunkLog::Key& key,
                           std::uint64_t chunks) {
  std::vector<double> times;
  log.for_each(key, chunks, [&](const StabilityTally& tally) {
    if (tally.timed > 0)
      times.push_back(static_cast<double>(tally.nanoseconds) / static_cast<double>(tally.timed));
  });
  if (times.size() < 2) return "unknown";
  const auto [least, most] = std::minmax_element(times.begin(), times.end());
  return fmt::format("{:.3g}..{:.3g}", *least, *most);
}

Result<VerbOutput> run_families(const Options& options) {
  const Chunks chunks{options.count, kRaysAChunk};
  FLATRAY_TRY(log, StabilityLog::open(options.text("output"), Outputs(options)));
  std::vector<TracerInTier> asked;
  asked.reserve(options.tracers.size() * options.tiers.size());
  for (const Tracer* tracer : options.tracers)
    for (const Isa isa : options.tiers) asked.push_back({tracer, isa});
  Table table({"family", "tracer", "isa", "rays", "hits", "wrong", "missed", "invented",
               "other_wall", "t_not_nearest", "t_off", "t_ulps", "t_ulps_99.9%", "one_by_one",
               "ns_a_query", "ns_of_chunks", "bytes_an_object", "first_wrong"});
  std::uint64_t wrong = 0;
  for (const oracle::Family& family : oracle::families()) {
    if (!options.chooses(family.name)) continue;
    std::vector<ChunkLog::Key> keys;
    keys.reserve(asked.size());
    for (const auto& [tracer, isa] : asked)
      keys.push_back({family.name, tracer->name, isa_name(isa), options.seed, 0});
    FLATRAY_TRY(done, log->run(keys, chunks, options.scene.limits.threads,
                               [&](std::uint64_t first, std::uint64_t count, const Open& open) {
                                 return check_rays(chosen(asked, open), family, options.seed, first,
                                                   count);
                               }));
    for (const ChunkLog::Key& key : keys) {
      const StabilityTally sum = log->sum(key, chunks.number());
      wrong += sum.wrong + sum.off_by_more;
      table.add({family.name, key.tracer, key.isa, sum.rays, sum.hits, sum.wrong, sum.missed,
                 sum.invented, sum.other_wall, sum.not_nearest, sum.off_by_more, sum.worst_ulps,
                 sum.most_ulps(), share(sum.one_by_one, sum.watched),
                 share(sum.nanoseconds, sum.timed), range_of_times(*log, key, chunks.number()),
                 share(sum.bytes, sum.objects), sum.first_wrong});
    }
  }
  return stability_output(std::move(table), wrong == 0);
}

Result<VerbOutput> run(const Options& options) {
  if (!options.operands().empty()) return report_margins(options);
  if (options.pairs) return run_pairs(options);
  if (options.leaks) return report_leaks(options);
  if (!options.catalogue && !options.sweep) return run_families(options);
  StabilityRequest request = options;
  if (!request.named) request.tracers = tracers_at_hand(options);
  return options.catalogue ? report_catalogue(request) : report_sweep(request);
}

}  // namespace

extern const Verb entry = {
    "stability",
    "[SCENE]",
    "compare tracers and contacts with exact arithmetic on inputs made to be hard",
    kCommand<Options, &run>,
    "  flatray stability --count 1000000 -o out/stability\n"
    "  flatray stability --families vertex,edge --tracer grid,float\n"
    "  flatray stability --families tangents,arc-ends,ellipses --tiers portable,baseline\n"
    "  flatray stability --leaks 100000 --tracer grid --places origin,scaled-by-1e15 -o out/leaks\n"
    "  flatray stability --pairs 10000 -o out/pairs\n"
    "  flatray stability --catalogue -o out/stability\n"
    "  flatray stability --sweep -o out/stability\n"
    "  flatray stability scenes/chamber/hall.toml   # which of its rays are near a decision\n",
    "",
    nullptr,
    kRowsKept};

}  // namespace flatray::stability_verb
