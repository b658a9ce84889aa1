#include "app/tracer_choice.h"

#include "app/option_values.h"

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

Result<const Tracer*> chosen_tracer(const Arguments& arguments) {
  const auto name = arguments.text("tracer");
  if (!name) return nullptr;
  return usable_tracer(*name, arguments.where("tracer"));
}

}  // namespace flatray
