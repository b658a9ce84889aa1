// flatray stability --catalogue.
#include <fmt/core.h>

#include "app/stability_reports.h"
#include "base/parallel.h"
#include "study/catalogue_check.h"

namespace flatray {
namespace {

const std::vector<std::string> kColumns = {
    "id",     "case",         "tracer",     "queries",         "wrong",   "leaks", "apart",
    "t_ulps", "t_ulps_99.9%", "one_by_one", "bytes_an_object", "verdict", "test"};
constexpr std::size_t kTimes = 10;  // the column after which what was measured is shown

std::string share(double part, double all) {
  return all == 0 ? "" : fmt::format("{:.3g}", part / all);
}

Values row_of(const oracle::StiffCase& stiff, const Tracer& tracer, const CatalogueTally& tally) {
  const auto number = [](std::uint64_t count) { return static_cast<double>(count); };
  return {stiff.id,
          stiff.words,
          tracer.name,
          tally.queries,
          tally.wrong,
          tally.leaks,
          tally.apart,
          tally.worst_ulps(),
          tally.most_ulps(),
          tracer.exact ? share(number(tally.one_by_one), number(tally.in_batches)) : "",
          share(number(tally.bytes), number(tally.objects)),
          tally.right() ? "right" : "wrong",
          stiff.held_by};
}

JsonValue nanoseconds(const CatalogueTally& tally) {
  if (tally.in_batches == 0) return "";
  return fmt::format("{:.3g}", 1e9 * tally.seconds / static_cast<double>(tally.in_batches));
}

// What is the same every time, and what was measured.
struct CatalogueTables {
  ReportTable facts{kColumns, {}}, shown{kColumns, {}}, times{{"id", "tracer", "ns_a_query"}, {}};

  CatalogueTables() { shown.columns.insert(shown.columns.begin() + kTimes, "ns_a_query"); }
  void add(Values row, const JsonValue& ns) {
    if (ns.as_text() != "") times.rows.push_back({row[0], row[2], ns});
    facts.rows.push_back(row);
    row.insert(row.begin() + kTimes, ns);
    shown.rows.push_back(std::move(row));
  }
};

}  // namespace

Result<VerbOutput> report_catalogue(const Arguments& arguments, const StabilityRequest& request) {
  const std::vector<oracle::StiffCase> cases = oracle::catalogue();
  std::vector<std::vector<CatalogueTally>> tallies(cases.size());
  parallel_for(cases.size(), request.threads,
               [&](std::size_t i) { tallies[i] = check_case(cases[i], request.tracers); });
  CatalogueTables tables;
  std::vector<CatalogueTally> sums(request.tracers.size());
  std::vector<std::size_t> right(request.tracers.size());
  std::size_t asked = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (!cases[i].concerns_tracers()) {
      Values row(kColumns.size(), "");
      row[0] = cases[i].id, row[1] = cases[i].words;
      row[kColumns.size() - 2] = "by its test", row.back() = cases[i].held_by;
      tables.add(std::move(row), "");
      continue;
    }
    ++asked;
    for (std::size_t k = 0; k < request.tracers.size(); ++k) {
      sums[k].add(tallies[i][k]);
      right[k] += tallies[i][k].right() ? 1 : 0;
      tables.add(row_of(cases[i], *request.tracers[k], tallies[i][k]), nanoseconds(tallies[i][k]));
    }
  }
  ExperimentResult result;
  result.summary = fmt::format("\n{} cases, {} of them asked of tracers\n", cases.size(), asked);
  bool sound = true;
  for (std::size_t k = 0; k < right.size(); ++k) {
    const Tracer& tracer = *request.tracers[k];
    tables.add(row_of({"all", "", ""}, tracer, sums[k]), nanoseconds(sums[k]));
    const bool good = right[k] == asked;
    sound = sound && (good || !(request.named || tracer.exact));
    result.summary += fmt::format("{}: {}, {} of {} right\n", tracer.name, good ? "right" : "wrong",
                                  right[k], asked);
  }
  result.files.push_back({"catalogue.csv", csv_text(tables.facts)});
  result.files.push_back({"catalogue_times.csv", csv_text(tables.times)});
  return stability_files(arguments, tables.shown, result, sound);
}

}  // namespace flatray
