#include "study/stability/stability.h"

#include <fmt/core.h>

#include "app/answers/stability_reports.h"
#include "app/files/chunk_log.h"
#include "app/files/scene_input.h"
#include "app/options/option_values.h"
#include "app/options/tracer_choice.h"
#include "app/report/report.h"
#include "app/verb.h"
#include "base/isa.h"
#include "study/stability/leaks.h"
#include "study/stability/pair_stability.h"

namespace flatray::verbs {
namespace {

std::vector<std::string> family_names() { return names_of(oracle::families()); }
std::vector<std::string> place_names() { return names_of(room_places()); }

std::vector<std::string> pair_family_names() { return names_of(pair_families()); }

// What is checked where no tracer is named; the others are wrong now and then.
std::vector<std::string> exact_tracers() {
  std::vector<std::string> names;
  for (const Tracer* tracer : tracers())
    if (tracer->exact) names.emplace_back(tracer->name);
  return names;
}

std::vector<std::string> all_family_names() {
  std::vector<std::string> names = family_names();
  for (std::string& name : pair_family_names()) names.push_back(std::move(name));
  return names;
}

constexpr auto kOptions = with_scene_options(
    {{"families", '\0', "NAME,NAME",
      "only these families of inputs, as docs/NUMERICS.md names them; with --pairs, families of "
      "pairs",
      OptionKind::text, &all_family_names},
     {"tracer", '\0', "NAME,NAME", "these tracers instead of all exact ones", OptionKind::text,
      &tracer_names},
     {"count", '\0', "N",
      "rays of each family for each tracer, in chunks of 16384 (default 100000)"},
     {"leaks", '\0', "N",
      "instead, for each tracer N rays aimed at the vertices of each sealed room, in blocks of "
      "1024"},
     {"places", '\0', "NAME,NAME", "of --leaks: only where these rooms stand", OptionKind::text,
      &place_names},
     {"pairs", '\0', "N",
      "instead, N moving pairs of each family, in chunks of 1024, against exact contacts"},
     {"catalogue", '\0', "", "instead, the catalogue of stiff cases by id, for all tracers",
      OptionKind::flag},
     {"sweep", '\0', "", "instead, scales and offsets from 2^-1000 to 2^1000, for all tracers",
      OptionKind::flag},
     {"seed", '\0', "N", "seed of all draws (default 1)"},
     {"output", 'o', "FOLDER",
      "where its files go: stability.csv, or leaks.csv, a row a chunk, from which a run with the "
      "same seed goes on"},
     kForceOption,
     kThreadsOption,
     kJsonOption});

// What to check; a chunk of a family is named by its number.
struct Plan {
  std::vector<const oracle::Family*> families;
  std::vector<PairFamily> pair_families;  // with --pairs instead of `families`
  std::vector<const Tracer*> tracers;
  std::uint64_t seed = 1, chunks = 1;
  unsigned threads = 1;
};

Result<Plan> read_plan(const Arguments& arguments) {
  Plan plan;
  const bool pairs = arguments.has("pairs");
  const auto families =
      chosen_names(arguments, "families", "family", pairs ? pair_family_names() : family_names());
  if (!families) return tl::unexpected(families.error());
  const auto names = chosen_names(arguments, "tracer", "tracer", tracer_names());
  if (!names) return tl::unexpected(names.error());
  const auto seed = arguments.whole("seed", 1, 0, ~std::uint64_t{0});
  if (!seed) return tl::unexpected(seed.error());
  const auto count = arguments.whole("count", 100'000, 1, std::uint64_t{1} << 40);
  if (!count) return tl::unexpected(count.error());
  const auto width = threads(arguments);
  if (!width) return tl::unexpected(width.error());
  const auto chosen = [&](const auto& family) {
    return std::find(families->begin(), families->end(), family.name) != families->end();
  };
  for (const oracle::Family& family : oracle::families())
    if (!pairs && chosen(family)) plan.families.push_back(&family);
  for (PairFamily& family : flatray::pair_families())
    if (pairs && chosen(family)) plan.pair_families.push_back(std::move(family));
  for (const std::string& name : arguments.has("tracer") ? *names : exact_tracers()) {
    const auto tracer = usable_tracer(name, arguments.where("tracer"));
    if (!tracer) return tl::unexpected(tracer.error());
    plan.tracers.push_back(*tracer);
  }
  plan.seed = *seed;
  plan.chunks = (*count + kRaysAChunk - 1) / kRaysAChunk;
  plan.threads = *width;
  return plan;
}

// Those of `names` in a family of this run.
std::vector<ChunkLog::Key> keys_of(const Plan& plan, const std::string& family,
                                   const std::vector<std::string>& names) {
  std::vector<ChunkLog::Key> keys;
  for (const std::string& name : names)
    keys.push_back({family, name, isa_name(active_isa()), plan.seed, 0});
  return keys;
}

Result<void> run_family(const Plan& plan, const oracle::Family& family,
                        const std::vector<ChunkLog::Key>& keys, StabilityLog& log) {
  return log.run(keys, plan.chunks, plan.threads,
                 [&](std::uint64_t chunk, const std::vector<std::size_t>& open) {
                   std::vector<const Tracer*> asked;
                   for (const std::size_t k : open) asked.push_back(plan.tracers[k]);
                   return check_scenes(asked, family, plan.seed, chunk * kScenesAChunk,
                                       kScenesAChunk);
                 });
}

Result<void> run_pair_family(const Plan& plan, const PairFamily& family, std::uint64_t chunks,
                             const std::vector<ChunkLog::Key>& keys, StabilityLog& log) {
  return log.run(
      keys, chunks, plan.threads, [&](std::uint64_t chunk, const std::vector<std::size_t>& open) {
        const auto all = check_pairs(family, plan.seed, chunk * kPairsAChunk, kPairsAChunk);
        std::vector<StabilityTally> tallies;
        for (const std::size_t k : open) tallies.push_back(all[k]);
        return tallies;
      });
}

Result<VerbOutput> run_pairs(const Arguments& arguments, const Plan& plan) {
  if (arguments.has("tracer"))
    return usage_error(arguments.where("tracer"), "does not go with --pairs",
                       "leave one of them out");
  const auto pairs = arguments.whole("pairs", 1, 1, std::uint64_t{1} << 40);
  if (!pairs) return tl::unexpected(pairs.error());
  const std::uint64_t chunks = (*pairs + kPairsAChunk - 1) / kPairsAChunk;
  auto log = StabilityLog::open(arguments.text("output"), Outputs(arguments));
  if (!log) return fail(std::move(log));
  Table table{{"family", "method", "pairs", "meet", "wrong", "missed", "invented", "other_class",
               "t_not_nearest_or_wide", "t_off", "first_wrong"},
              {}};
  std::uint64_t wrong = 0;
  for (const PairFamily& family : plan.pair_families) {
    const auto keys = keys_of(plan, StabilityRows::pairs(family), family.methods);
    if (auto done = run_pair_family(plan, family, chunks, keys, *log); !done)
      return fail(std::move(done));
    for (std::size_t k = 0; k < keys.size(); ++k) {
      const StabilityTally sum = log->sum(keys[k], chunks);
      wrong += sum.wrong + sum.off_by_more;
      table.add({family.name, family.methods[k], sum.rays, sum.hits, sum.wrong, sum.missed,
                 sum.invented, sum.other_wall, sum.not_nearest, sum.off_by_more, sum.first_wrong});
    }
  }
  return stability_output(std::move(table), wrong == 0);
}

// What stands instead of the families: of a scene, --catalogue, --sweep, --leaks and --pairs one at
// most.
Result<std::string> what_to_do(const Arguments& arguments) {
  std::string what = arguments.operands().empty() ? "families" : "scene";
  for (const char* other : {"catalogue", "sweep", "leaks", "pairs"}) {
    if (!arguments.has(other)) continue;
    if (what != "families")
      return usage_error(arguments.where(other),
                         "does not go with " + (what == "scene" ? "a scene" : "--" + what),
                         "leave one of them out");
    what = other;
  }
  if (what != "leaks" && arguments.has("places"))
    return usage_error(arguments.where("places"), "is about --leaks", "leave it out");
  if (what != "families")
    for (const char* other : {"families", "count"})
      if (arguments.has(other) && !(what == "pairs" && std::string(other) == "families"))
        return usage_error(arguments.where(other), "is about the families of inputs",
                           "leave it out");
  return what;
}

// Part of a whole, of that which was counted: chunks of before have fewer counts.
std::string share(std::uint64_t part, std::uint64_t whole) {
  if (whole == 0) return "unknown";
  return fmt::format("{:.3g}", static_cast<double>(part) / static_cast<double>(whole));
}

// From the quickest chunk to the slowest: how far the mean of one run can be trusted. One chunk alone
// does not tell.
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

JsonValue known(const StabilityTally& tally, std::uint64_t ulps) {
  return tally.timed == tally.rays ? JsonValue(ulps) : JsonValue("unknown");
}

Result<VerbOutput> run(const Arguments& arguments) {
  const auto what = what_to_do(arguments);
  if (!what) return tl::unexpected(what.error());
  const auto plan = read_plan(arguments);
  if (!plan) return tl::unexpected(plan.error());
  const bool named = arguments.has("tracer");
  StabilityRequest request{plan->tracers, named, plan->seed, plan->threads};
  if (*what == "scene") return report_margins(arguments, request);
  if (!named && *what != "families" && *what != "leaks" && *what != "pairs")
    request.tracers = tracers_at_hand();
  if (*what == "catalogue") return report_catalogue(arguments, request);
  if (*what == "sweep") return report_sweep(arguments, request);
  if (*what == "pairs") return run_pairs(arguments, *plan);
  if (*what == "leaks") return report_leaks(arguments, request);
  auto log = StabilityLog::open(arguments.text("output"), Outputs(arguments));
  if (!log) return fail(std::move(log));
  Table table{{"family", "tracer", "rays", "hits", "wrong", "missed", "invented", "other_wall",
               "t_not_nearest", "t_off", "t_ulps", "t_ulps_99.9%", "one_by_one", "ns_a_query",
               "ns_of_chunks", "bytes_an_object", "first_wrong"},
              {}};
  std::uint64_t wrong = 0;
  for (const oracle::Family* family : plan->families) {
    const auto keys = keys_of(*plan, family->name, names_of(plan->tracers));
    if (auto done = run_family(*plan, *family, keys, *log); !done) return fail(std::move(done));
    for (const ChunkLog::Key& key : keys) {
      const StabilityTally sum = log->sum(key, plan->chunks);
      wrong += sum.wrong + sum.off_by_more;
      table.add({family->name, key.tracer, sum.rays, sum.hits, sum.wrong, sum.missed, sum.invented,
                 sum.other_wall, sum.not_nearest, sum.off_by_more, known(sum, sum.worst_ulps),
                 known(sum, sum.most_ulps()), share(sum.one_by_one, sum.watched),
                 share(sum.nanoseconds, sum.timed), range_of_times(*log, key, plan->chunks),
                 share(sum.bytes, sum.objects), sum.first_wrong});
    }
  }
  return stability_output(std::move(table), wrong == 0);
}

}  // namespace

extern const Verb stability = {
    "stability",
    "[SCENE]",
    "compare tracers and contacts with exact arithmetic on inputs made to be hard",
    0,
    1,
    kOptions,
    "  flatray stability --count 1000000 -o out/stability\n"
    "  flatray stability --families vertex,edge --tracer grid,float\n"
    "  flatray stability --families tangents,arc-ends,ellipses\n"
    "  flatray stability --leaks 100000 --tracer grid --places origin,scaled-by-1e15 -o out/leaks\n"
    "  flatray stability --pairs 10000 -o out/pairs\n"
    "  flatray stability --catalogue -o out/stability\n"
    "  flatray stability --sweep -o out/stability\n"
    "  flatray stability scenes/chamber/hall.toml   # which of its rays are near a decision\n",
    "",
    &run,
    nullptr,
    kRowsKept};

}  // namespace flatray::verbs
