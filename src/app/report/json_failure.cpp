#include "app/report/json_failure.h"

#include "app/report/report.h"

namespace flatray {

std::string json_failure(const char* verb, const Arguments& arguments,
                         const Diagnostics& problems) {
  if (!arguments.has("json")) return "";
  Values errors;
  for (const Diagnostic& one : problems) errors.push_back(as_value(one));
  return json_report(verb, arguments, Fields{{"errors", std::move(errors)}});
}

}  // namespace flatray
