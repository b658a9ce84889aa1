#pragma once
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/options/arguments.h"
#include "base/table.h"
#include "geom/vec.h"
#include "image/compare.h"

namespace flatray {

/// Exit code of a failure: that of its first diagnostic (docs/LIMITS.md).
int exit_code(const Diagnostics& problems);

/// Mistakes on standard error and the closing line "flatray: 2 errors, nothing rendered".
/// Gives   the exit code.
int report_failure(const Diagnostics& problems, const std::string& undone);

/// Warnings on standard error, unless the verb was given --quiet, and in the object of --json; each
/// once, as a scene may be read for each value of a sweep.
void report_warnings(const Diagnostics& warnings, const Arguments& arguments);

/// One line for people on standard error.
void report_note(const std::string& line);

/// What a verb that ran has to say, built once and written in the form asked for. Mistakes are the
/// failed Result instead; their Trouble decides the exit code.
struct VerbOutput {
  /// For people, one after the other; the table where there is nothing here.
  std::vector<std::variant<std::string, Table>> text{};
  JsonValue results{};  ///< of --json; null: the table, a failure's errors, or no JSON at all
  Fields of_all{};      ///< beside the results
  std::optional<Table> table{};  ///< of --csv
  int exit_code = 0;             ///< 0, 1 (the answer is no) or interrupted_code()
  Diagnostics problems{};  ///< that end the answer: told after it, as those of a failed Result
  bool picture = false;    ///< the text is bytes of a file
  std::shared_ptr<const void> kept{};  ///< keeps alive what Table::made makes rows of

  /// One more of a list of results, and its text.
  void add(JsonValue result, std::string words);
};

/// The output in the form asked for; takes its results out of it. --json prints one object: schema
/// "flatray.VERB/1", version, args, results, timing (seconds from when the arguments were read
/// until this is written), warnings, what the verb tells of all results, and its problems as
/// "errors".
std::string written(const char* verb, const Arguments& arguments, VerbOutput& output);
/// The results of a verb that failed: "errors".
JsonValue failed_results(const Diagnostics& problems);

/// A point as people read it: "(0.5, -2)".
std::string point_text(const Vec2& point);

/// "worst pixel (111, 87) green: 190, expected 153; 12 of 40000 pixels differ". Needs a difference.
std::string difference_text(const Difference& difference);

/// As JSON: [x, y].
JsonValue as_value(const Vec2& point);

/// Diagnostics as objects: file, line, column, message, hint.
Values as_values(const Diagnostics& diagnostics);

}  // namespace flatray
