#pragma once
#include <string>

#include "app/options/arguments.h"
#include "app/report/value.h"
#include "base/result.h"
#include "geom/vec.h"

namespace flatray {

/// Exit code of a failure: that of its first diagnostic (docs/LIMITS.md).
int exit_code(const Diagnostics& problems);

/// Mistakes on standard error and the closing line "flatray: 2 errors, nothing rendered".
/// Gives   the exit code.
int report_failure(const Diagnostics& problems, const std::string& undone);

/// Warnings on standard error, unless the verb was given --quiet.
void report_warnings(const Diagnostics& warnings, const Arguments& arguments);

/// One line for people on standard error.
void report_note(const std::string& line);

/// The one object --json prints: schema "flatray.VERB/1", version, args, results, timing (seconds
/// since the arguments were read), and what the verb tells of all results.
std::string json_report(const char* verb, const Arguments& arguments, JsonValue results,
                        Fields of_all = {});

/// A point as people read it: "(0.5, -2)".
std::string point_text(const Vec2& point);

/// A diagnostic as an object: file, line, column, message, hint.
JsonValue as_value(const Diagnostic& diagnostic);

}  // namespace flatray
