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

struct Options : Arguments {
  void rows(OptionTable& row) { row(kJsonRow); }
};

template <class Entries>
Table described(const Entries& entries) {
  Table table({"name", "what"});
  for (const auto* one : entries) table.add({one->name, one->summary});
  return table;
}

Table listed(const std::vector<Listed>& entries) {
  Table table({"name", "what"});
  for (const Listed& one : entries) table.add({one.name, one.usage});
  return table;
}

Table drawing_passes() {
  Table table({"name"});
  for (const Pass* one : flatray::passes()) table.add({one->name});
  return table;
}

Table studies() {
  Table table({"name", "what"});
  for (const Experiment* one : flatray::experiments()) table.add({one->name, one->question});
  return table;
}

Table isas() {
  Table table({"name", "what"});
  for (const Isa one : available_isas())
    table.add({isa_name(one), one == active_isa() ? "running" : ""});
  return table;
}

struct Kind {
  const char* name;
  Table (*entries)();
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

Result<VerbOutput> run(const Options& options) {
  const std::string wanted = options.operands().empty() ? "" : options.operands().front();
  Fields all;
  VerbOutput output;
  for (const Kind& kind : kKinds) {
    if (!wanted.empty() && wanted != kind.name) continue;
    Table table = kind.entries();
    all.emplace_back(kind.name, table);
    table.columns.clear();
    if (wanted.empty()) output.text.emplace_back(fmt::format("{}\n", kind.name));
    output.text.emplace_back(aligned_text(table, {wanted.empty() ? "  " : ""}));
  }
  if (all.empty()) return unknown_name(named_place("list"), "list", wanted, kind_names());
  output.results = std::move(all);
  return output;
}

}  // namespace

extern const Verb list = {"list",
                          "[KIND]",
                          "show what is registered, as shapes, formats, tracers and experiments",
                          0,
                          1,
                          kCommand<Options, &run>,
                          "  flatray list shapes\n",
                          "",
                          &kind_names};

}  // namespace flatray::verbs
