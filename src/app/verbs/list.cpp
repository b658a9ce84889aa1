#include <fmt/core.h>

#include "app/files/scene_input.h"
#include "app/options/option_values.h"
#include "app/report/report.h"
#include "app/verb.h"
#include "base/isa.h"
#include "image/metric.h"
#include "image/picture_format.h"
#include "render/backend.h"
#include "render/view.h"
#include "study/experiment.h"
#include "trace/tracer.h"

namespace flatray::verbs {
namespace {

constexpr Option kOptions[] = {kJsonOption};

template <class Entries>
ReportTable described(const Entries& entries) {
  ReportTable table{{"name", "what"}, {}};
  for (const auto* one : entries) table.rows.push_back({one->name, one->summary});
  return table;
}

ReportTable listed(const std::vector<Listed>& entries) {
  ReportTable table{{"name", "what"}, {}};
  for (const Listed& one : entries) table.rows.push_back({one.name, one.usage});
  return table;
}

ReportTable drawing_passes() {
  ReportTable table{{"name"}, {}};
  for (const Pass* one : flatray::passes()) table.rows.push_back({one->name});
  return table;
}

ReportTable studies() {
  ReportTable table{{"name", "what"}, {}};
  for (const Experiment* one : flatray::experiments())
    table.rows.push_back({one->name, one->question});
  return table;
}

ReportTable isas() {
  ReportTable table{{"name", "what"}, {}};
  for (const Isa one : available_isas())
    table.rows.push_back({isa_name(one), one == active_isa() ? "running" : ""});
  return table;
}

struct Kind {
  const char* name;
  ReportTable (*entries)();
};
constexpr Kind kKinds[] = {{"backends", [] { return described(flatray::backends()); }},
                           {"encoders", [] { return described(flatray::png_writers()); }},
                           {"experiments", &studies},
                           {"formats", [] { return listed(listed_formats()); }},
                           {"isas", &isas},
                           {"lamps", [] { return listed(listed_lamps()); }},
                           {"materials", [] { return listed(listed_materials()); }},
                           {"metrics", [] { return described(flatray::metrics()); }},
                           {"passes", &drawing_passes},
                           {"pictures", [] { return described(flatray::picture_formats()); }},
                           {"shapes", [] { return listed(listed_shapes()); }},
                           {"tracers", [] { return described(flatray::tracers()); }},
                           {"views", [] { return described(flatray::views()); }},
                           {"verbs", [] { return described(all_verbs()); }}};

std::vector<std::string> kind_names() { return names_of(kKinds); }

Result<VerbOutput> run(const Arguments& arguments) {
  const std::string wanted = arguments.operands().empty() ? "" : arguments.operands().front();
  Fields all;
  std::string text;
  for (const Kind& kind : kKinds) {
    if (!wanted.empty() && wanted != kind.name) continue;
    ReportTable table = kind.entries();
    all.emplace_back(kind.name, as_objects(table));
    table.columns.clear();
    if (wanted.empty()) text += fmt::format("{}\n", kind.name);
    text += aligned_text(table, wanted.empty() ? "  " : "");
  }
  if (all.empty()) return unknown_name(named_place("list"), "list", wanted, kind_names());
  if (arguments.has("json")) text = json_report("list", arguments, std::move(all));
  return VerbOutput{std::move(text)};
}

}  // namespace

extern const Verb list = {"list",
                          "[KIND]",
                          "show what is registered, as shapes, formats, tracers and experiments",
                          0,
                          1,
                          kOptions,
                          "  flatray list shapes\n",
                          "",
                          &run,
                          &kind_names};

}  // namespace flatray::verbs
