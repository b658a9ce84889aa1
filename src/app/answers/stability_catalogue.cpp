// flatray stability --catalogue.
#include <fmt/core.h>

#include <algorithm>

#include "app/answers/stability_reports.h"
#include "base/number_text.h"
#include "base/parallel.h"
#include "precise/certified_orbit.h"
#include "study/stability/catalogue_check.h"

namespace flatray {
namespace {

const std::vector<std::string> kColumns = {
    "id",     "case",         "tracer",     "queries",    "wrong",           "leaks",   "apart",
    "t_ulps", "t_ulps_99.9%", "one_by_one", "ns_a_query", "bytes_an_object", "verdict", "test"};
constexpr std::size_t kTimes = 10;  // the column of what was measured

// To three digits; nothing of none.
JsonValue share(double part, double all) {
  return all == 0 ? JsonValue() : *parse_number(fmt::format("{:.3g}", part / all));
}

// Who is asked about a case, and whether there is something to tell of leaks, of t, and of what
// goes through lanes.
struct Asked {
  std::string name;
  bool leaks, times, lanes;
  bool decides = true;  // the exit code
  const char* of = "";  // which cases it is asked about
};

// Tracers, then certified orbits and contacts, which keep nothing beside the walls.
std::vector<Asked> all_asked(const StabilityRequest& request) {
  std::vector<Asked> all;
  for (const Tracer* one : request.tracers)
    all.push_back({one->name, true, true, one->exact, request.named || one->exact});
  all.push_back({"certified", true, false, false, true, " with orbits"});
  all.push_back({"contact", false, true, false});
  return all;
}

Values row_of(const oracle::StiffCase& stiff, const Asked& asked, const CatalogueTally& tally) {
  const auto number = [](std::uint64_t count) { return static_cast<double>(count); };
  const auto told = [](bool is, JsonValue value) { return is ? std::move(value) : JsonValue(); };
  return {stiff.id,
          stiff.words,
          asked.name,
          tally.queries,
          tally.wrong,
          told(asked.leaks, tally.leaks),
          told(asked.times, tally.apart),
          told(asked.times, tally.worst_ulps()),
          told(asked.times, tally.most_ulps()),
          told(asked.lanes, share(number(tally.one_by_one), number(tally.in_batches))),
          share(1e9 * tally.seconds, number(tally.in_batches)),
          share(number(tally.bytes), number(tally.objects)),
          tally.right() ? "right" : "wrong",
          stiff.held_by};
}

// How many cases came out right, of those asked, and all of them together.
struct Score {
  CatalogueTally sum;
  std::size_t right = 0, asked = 0;

  void add(const CatalogueTally& tally) {
    sum.add(tally);
    ++asked;
    right += tally.right() ? 1 : 0;
  }
  bool sound() const { return right == asked; }
  std::string words(const Asked& who) const {
    return fmt::format("{}: {}, {} of {}{} right\n", who.name, sound() ? "right" : "wrong", right,
                       asked, who.of);
  }
};

Values row_of_its_test(const oracle::StiffCase& stiff) {
  Values row(kColumns.size());
  row[0] = stiff.id, row[1] = stiff.words, row[2] = stiff.matter;
  row[kColumns.size() - 2] = "by its test", row.back() = stiff.held_by;
  return row;
}

// Of each case a tally of each of those asked, where it concerns them.
using Checked = std::vector<std::optional<CatalogueTally>>;

std::vector<Checked> check_all(const std::vector<oracle::StiffCase>& cases,
                               const StabilityRequest& request) {
  const bool certifies = !request.named && can_certify().has_value();
  const std::size_t tracers = request.tracers.size();
  std::vector<Checked> checked(cases.size(), Checked(tracers + 2));
  parallel_for(cases.size(), request.scene.limits.threads, [&](std::size_t i) {
    if (cases[i].concerns_tracers())
      std::ranges::move(check_case(cases[i], request.tracers), checked[i].begin());
    if (!cases[i].contacts.empty()) checked[i].back() = check_contacts(cases[i]);
    if (!certifies || cases[i].orbits.empty()) return;
    if (auto tally = check_certified(cases[i])) checked[i][tracers] = *std::move(tally);
  });
  return checked;
}

}  // namespace

Result<VerbOutput> report_catalogue(const StabilityRequest& request) {
  const std::vector<oracle::StiffCase> cases = oracle::catalogue();
  const std::vector<Checked> checked = check_all(cases, request);
  const std::vector<Asked> asked = all_asked(request);
  Table shown(kColumns);
  std::vector<Score> scores(asked.size());
  std::size_t of_tracers = 0, of_none = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (cases[i].concerns_tracers())
      ++of_tracers;
    else if (cases[i].contacts.empty()) {
      ++of_none;
      shown.add(row_of_its_test(cases[i]));
    }
    for (std::size_t k = 0; k < asked.size(); ++k)
      if (const auto& tally = checked[i][k]) {
        scores[k].add(*tally);
        shown.add(row_of(cases[i], asked[k], *tally));
      }
  }
  ExperimentResult result;
  result.summary = fmt::format(
      "\n{} cases: {} asked of tracers, {} of contact, {} of files and pictures by their tests\n",
      cases.size(), of_tracers, scores.back().asked, of_none);
  bool sound = true;
  for (std::size_t k = 0; k < asked.size(); ++k) {
    if (scores[k].asked == 0) continue;
    shown.add(row_of({"all", "", ""}, asked[k], scores[k].sum));
    sound = sound && (scores[k].sound() || !asked[k].decides);
    result.summary += scores[k].words(asked[k]);
  }
  result.summary += fmt::format(
      "ns_a_query: processor time, of tracers the least of up to {} measurements, of certified "
      "orbits one alone\n",
      kTimesOfACase);
  Table facts = shown, times({"id", "tracer", "ns_a_query"});
  facts.columns.erase(facts.columns.begin() + kTimes);
  for (Values& row : facts.rows) {
    if (row[kTimes].as_number()) times.add({row[0], row[2], row[kTimes]});
    row.erase(row.begin() + kTimes);
  }
  result.files.push_back(csv_file("catalogue", facts));
  result.files.push_back(csv_file("catalogue_times", times));
  return stability_files(request, std::move(shown), result, sound);
}

}  // namespace flatray
