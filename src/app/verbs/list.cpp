#include <fmt/core.h>

#include "app/option_values.h"
#include "app/report.h"
#include "app/scene_input.h"
#include "app/verb.h"
#include "base/isa.h"
#include "render/plan.h"
#include "study/experiment.h"

namespace flatray::verbs {
namespace {

constexpr Option kOptions[] = {kJsonOption};

Table named(std::vector<Values> rows) { return {{"name", "what"}, std::move(rows)}; }

Table shapes() {
  std::vector<Values> rows;
  for (const Listed& one : listed_shapes()) rows.push_back({one.name, one.usage});
  return named(std::move(rows));
}

Table formats() {
  std::vector<Values> rows;
  for (const Listed& one : listed_formats()) rows.push_back({one.name, one.usage});
  return named(std::move(rows));
}

Table drawing_passes() {
  std::vector<Values> rows;
  for (const Pass* one : flatray::passes()) rows.push_back({one->name, ""});
  return named(std::move(rows));
}

Table studies() {
  std::vector<Values> rows;
  for (const Experiment* one : flatray::experiments()) rows.push_back({one->name, one->question});
  return named(std::move(rows));
}

Table words() {
  std::vector<Values> rows;
  for (const Verb* one : all_verbs()) rows.push_back({one->name, one->summary});
  return named(std::move(rows));
}

Table isas() {
  std::vector<Values> rows;
  for (const Isa one : available_isas())
    rows.push_back({isa_name(one), one == active_isa() ? "running" : ""});
  return named(std::move(rows));
}

struct Kind {
  const char* name;
  Table (*entries)();
};
constexpr Kind kKinds[] = {{"experiments", &studies},   {"formats", &formats}, {"isas", &isas},
                           {"passes", &drawing_passes}, {"shapes", &shapes},   {"verbs", &words}};

Result<VerbOutput> run(const Arguments& arguments) {
  const std::string wanted = arguments.operands().empty() ? "" : arguments.operands().front();
  Fields all;
  std::string text;
  std::vector<std::string> known;
  for (const Kind& kind : kKinds) {
    known.emplace_back(kind.name);
    if (!wanted.empty() && wanted != kind.name) continue;
    Table table = kind.entries();
    all.emplace_back(kind.name, as_objects(table));
    table.columns.clear();
    if (wanted.empty()) text += fmt::format("{}\n", kind.name);
    text += aligned_text(table, wanted.empty() ? "  " : "");
  }
  if (all.empty()) {
    const std::string near = nearest_word(wanted, known);
    return usage_error(named_place(wanted),
                       near.empty() ? "there is no list of that name"
                                    : fmt::format("no such list (did you mean {}?)", near),
                       "say one of: " + comma_list(known));
  }
  if (arguments.has("json")) text = json_report("list", arguments, std::move(all), 0);
  return VerbOutput{std::move(text)};
}

}  // namespace

extern const Verb list = {
    "list",
    "[KIND]",
    "show what is registered: shapes, formats, passes, experiments, isas, verbs",
    0,
    1,
    kOptions,
    "  flatray list shapes\n",
    "",
    &run};

}  // namespace flatray::verbs
