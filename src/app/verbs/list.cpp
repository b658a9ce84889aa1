#include <fmt/core.h>

#include <functional>

#include "app/files/scene_input.h"
#include "app/verb.h"
#include "base/isa.h"
#include "image/metric.h"
#include "image/picture_format.h"
#include "render/backend.h"
#include "render/view.h"
#include "scene/lamp.h"
#include "scene/material.h"
#include "scene/reading/format.h"
#include "scene/shape.h"
#include "study/experiment.h"
#include "trace/tracer.h"

namespace flatray::list_verb {
namespace {

struct Options : Arguments {
  void rows(OptionTable& row) { row(kJsonRow); }
};

// A row for each entry of `all()`, and what of it says what it is.
template <auto all, auto what>
Table listed() {
  Table table({"name", "what"});
  const auto entries = all();
  const std::vector<std::string> names = names_of(entries);
  for (std::size_t i = 0; i < names.size(); ++i)
    table.add({names[i], std::invoke(what, *entries[i])});
  return table;
}

Table drawing_passes() {
  Table table({"name"});
  for (const Pass* one : flatray::passes()) table.add({one->name});
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
constexpr Kind kKinds[] = {
    {"backends", &listed<&flatray::backends, &Backend::summary>},
    {"encoders", &listed<&flatray::png_writers, &PngWriter::summary>},
    {"experiments", &listed<&flatray::experiments, &Experiment::question>},
    {"formats", &listed<&flatray::formats, &Format::usage>},
    {"isas", &isas},
    {"lamps", &listed<&lamp_types, &LampType::summary>},
    {"materials", &listed<&material_types, &MaterialType::summary>},
    {"metrics", &listed<&flatray::metrics, &Metric::summary>},
    {"passes", &drawing_passes},
    {"pictures", &listed<&flatray::picture_formats, &PictureFormat::summary>},
    {"shapes", &listed<&shape_types, &flatray::usage>},
    {"tracers", &listed<&flatray::tracers, &Tracer::summary>},
    {"views", &listed<&flatray::views, &View::summary>},
    {"verbs", &listed<&all_verbs, &Verb::summary>}};

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

extern const Verb entry = {"list",
                           "[KIND]",
                           "show what is registered, as shapes, formats, tracers and experiments",
                           kCommand<Options, &run>,
                           "  flatray list shapes\n",
                           "",
                           &kind_names};

}  // namespace flatray::list_verb
