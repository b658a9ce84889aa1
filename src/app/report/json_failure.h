#pragma once
#include <string>

#include "app/options/arguments.h"
#include "app/report/value.h"
#include "base/result.h"

namespace flatray {

/// What --json prints of a verb that failed: the object of `json_report` with no results and with
/// "errors", each as `flatray check --json` gives it; "" without --json.
std::string json_failure(const char* verb, const Arguments& arguments, const Diagnostics& problems);

}  // namespace flatray
