#include "app/options/tracer_choice.h"

#include <fmt/core.h>

#include "app/options/option_values.h"

namespace flatray {

std::vector<std::string> tracer_names() { return names_of(tracers()); }

Result<const Tracer*> usable_tracer(const std::string& name, const Place& where) {
  const Tracer* tracer = find_tracer(name);
  if (tracer == nullptr) return unknown_name(where, "tracer", name, tracer_names());
  const std::string missing = tracer->missing == nullptr ? "" : tracer->missing();
  if (!missing.empty())
    return fail(where, "cannot use " + name + ": " + missing, "", Trouble::unavailable);
  return tracer;
}

Result<void> check_tracer_of_view(const Arguments& arguments, const Tracer* tracer,
                                  const View& view) {
  if (tracer == nullptr || tracer->exact || !view.asks_for_all) return {};
  std::string exact;
  for (const Tracer* other : tracers())
    if (other->exact) exact += (exact.empty() ? "" : " or ") + std::string(other->name);
  return usage_error(
      arguments.where("tracer"),
      fmt::format("'{}' finds the first wall of a ray alone, and the view {} asks for "
                  "all of them",
                  tracer->name, view.name),
      "say " + exact + ", or leave out --tracer");
}

Result<const Tracer*> chosen_tracer(const Arguments& arguments) {
  const auto name = arguments.text("tracer");
  if (!name) return nullptr;
  return usable_tracer(*name, arguments.where("tracer"));
}

Result<Precision> chosen_precision(const Arguments& arguments) {
  const auto word = arguments.one_of("precision", {"double", "certified"});
  if (!word) return tl::unexpected(word.error());
  const auto bits = arguments.whole("bits", kMostBits, 128, 1U << 24);
  if (!bits) return tl::unexpected(bits.error());
  const auto tracer = chosen_tracer(arguments);
  if (!tracer) return tl::unexpected(tracer.error());
  return Precision{*word == "certified", static_cast<unsigned>(*bits), *tracer};
}

}  // namespace flatray
