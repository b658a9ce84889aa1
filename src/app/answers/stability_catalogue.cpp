// flatray stability --catalogue.
#include <fmt/core.h>

#include "app/answers/stability_reports.h"
#include "base/parallel.h"
#include "precise/certified_orbit.h"
#include "study/stability/catalogue_check.h"

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

// Of certified orbits: no t, no lanes, nothing that is kept.
Values certified_row(const oracle::StiffCase& stiff, const CatalogueTally& tally) {
  return {stiff.id,     stiff.words, "certified", tally.queries,
          tally.wrong,  tally.leaks, "",          "",
          "",           "",          "",          tally.right() ? "right" : "wrong",
          stiff.held_by};
}

// Of contacts: t, but nothing that is kept, and no share that is decided one by one.
Values contact_row(const oracle::StiffCase& stiff, const CatalogueTally& tally) {
  return {stiff.id,          stiff.words, "contact",   tally.queries,
          tally.wrong,       "",          tally.apart, tally.worst_ulps(),
          tally.most_ulps(), "",          "",          tally.right() ? "right" : "wrong",
          stiff.held_by};
}

JsonValue nanoseconds(const CatalogueTally& tally) {
  if (tally.in_batches == 0) return "";
  return fmt::format("{:.3g}", 1e9 * tally.seconds / static_cast<double>(tally.in_batches));
}

// What is the same every time, and what was measured.
struct CatalogueTables {
  Table facts{kColumns, {}}, shown{kColumns, {}}, times{{"id", "tracer", "ns_a_query"}, {}};

  CatalogueTables() { shown.columns.insert(shown.columns.begin() + kTimes, "ns_a_query"); }
  void add(Values row, const JsonValue& ns) {
    if (ns.as_text() != "") times.add({row[0], row[2], ns});
    facts.rows.push_back(row);
    row.insert(row.begin() + kTimes, ns);
    shown.rows.push_back(std::move(row));
  }
};

// What is known of a case: a tally for each tracer, and of certified orbits and contacts where there
// are any.
struct Checked {
  std::vector<CatalogueTally> by_tracer;
  std::optional<CatalogueTally> certified, contacts;
};

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
  std::string words(const char* name, const char* of) const {
    return fmt::format("{}: {}, {} of {}{} right\n", name, sound() ? "right" : "wrong", right,
                       asked, of);
  }
};

void add_rows(const oracle::StiffCase& stiff, const std::vector<const Tracer*>& tracers,
              const Checked& checked, CatalogueTables& tables) {
  for (std::size_t k = 0; k < checked.by_tracer.size(); ++k)
    tables.add(row_of(stiff, *tracers[k], checked.by_tracer[k]), nanoseconds(checked.by_tracer[k]));
  if (checked.certified)
    tables.add(certified_row(stiff, *checked.certified), nanoseconds(*checked.certified));
  if (checked.contacts)
    tables.add(contact_row(stiff, *checked.contacts), nanoseconds(*checked.contacts));
}

Values row_of_its_test(const oracle::StiffCase& stiff) {
  Values row(kColumns.size(), "");
  row[0] = stiff.id, row[1] = stiff.words, row[2] = stiff.matter;
  row[kColumns.size() - 2] = "by its test", row.back() = stiff.held_by;
  return row;
}

std::vector<Checked> check_all(const std::vector<oracle::StiffCase>& cases,
                               const StabilityRequest& request) {
  const bool certifies = !request.named && can_certify().has_value();
  std::vector<Checked> checked(cases.size());
  parallel_for(cases.size(), request.threads, [&](std::size_t i) {
    if (cases[i].concerns_tracers()) checked[i].by_tracer = check_case(cases[i], request.tracers);
    if (!cases[i].contacts.empty()) checked[i].contacts = check_contacts(cases[i]);
    if (!certifies || cases[i].orbits.empty()) return;
    if (auto tally = check_certified(cases[i])) checked[i].certified = *std::move(tally);
  });
  return checked;
}

}  // namespace

Result<VerbOutput> report_catalogue(const Arguments& arguments, const StabilityRequest& request) {
  const std::vector<oracle::StiffCase> cases = oracle::catalogue();
  const std::vector<Checked> checked = check_all(cases, request);
  CatalogueTables tables;
  std::vector<Score> scores(request.tracers.size());
  Score certified, contacts;
  std::size_t of_tracers = 0, of_none = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const std::vector<CatalogueTally>& tallies = checked[i].by_tracer;
    if (!tallies.empty()) ++of_tracers;
    for (std::size_t k = 0; k < tallies.size(); ++k) scores[k].add(tallies[k]);
    if (checked[i].certified) certified.add(*checked[i].certified);
    if (checked[i].contacts) contacts.add(*checked[i].contacts);
    if (tallies.empty() && !checked[i].contacts) {
      ++of_none;
      tables.add(row_of_its_test(cases[i]), "");
    }
    add_rows(cases[i], request.tracers, checked[i], tables);
  }
  Checked all;
  for (const Score& score : scores) all.by_tracer.push_back(score.sum);
  if (certified.asked > 0) all.certified = certified.sum;
  all.contacts = contacts.sum;
  add_rows({"all", "", ""}, request.tracers, all, tables);
  ExperimentResult result;
  result.summary = fmt::format(
      "\n{} cases: {} asked of tracers, {} of contact, {} of files and pictures by their tests\n",
      cases.size(), of_tracers, contacts.asked, of_none);
  bool sound = certified.sound() && contacts.sound();
  for (std::size_t k = 0; k < scores.size(); ++k) {
    const Tracer& tracer = *request.tracers[k];
    sound = sound && (scores[k].sound() || !(request.named || tracer.exact));
    result.summary += scores[k].words(tracer.name, "");
  }
  if (all.certified) result.summary += certified.words("certified", " with orbits");
  result.summary += contacts.words("contact", "");
  result.summary += fmt::format(
      "ns_a_query: processor time, of tracers the least of up to {} measurements, of certified "
      "orbits one alone\n",
      kTimesOfACase);
  result.files.push_back(csv_file("catalogue", tables.facts));
  result.files.push_back(csv_file("catalogue_times", tables.times));
  return stability_files(arguments, std::move(tables.shown), result, sound);
}

}  // namespace flatray
