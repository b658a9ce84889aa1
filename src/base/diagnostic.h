#pragma once
#include <string>
#include <vector>

#include "base/source_text.h"

namespace flatray {

/// What went wrong, by the exit code that it decides (docs/LIMITS.md); a library never exits by
/// itself.
enum class Trouble {
  usage = 2,        ///< the command line is wrong
  missing = 3,      ///< an input is not there or cannot be read
  invalid = 4,      ///< an input is read but wrong
  unavailable = 5,  ///< a back end or optional part is not in this build
  output = 6,       ///< a result could not be written
};

/// One mistake: where it stands, what is wrong with the value, what to write instead.
struct Diagnostic {
  Place where;
  std::string message, hint;
  Trouble trouble = Trouble::invalid;
};

using Diagnostics = std::vector<Diagnostic>;

/// As the user reads it: `file:line:col: error: message`, the line, a marker under the value with
/// the hint; for a file that another includes, where.
std::string format(const Diagnostic& diagnostic, const char* severity = "error");
std::string format(const Diagnostics& diagnostics, const char* severity = "error");

/// What a message calls a thing of a scene: "lamp 'left'", or "lamp of line 12" where it has no name.
std::string called(std::string_view what, std::string_view name, const Place& where);

/// The entry of `known` nearest to `word` by edit distance, or "" when none is near: "did you
/// mean".
std::string nearest_word(std::string_view word, const std::vector<std::string>& known);

/// "box, circle, convex"
std::string comma_list(const std::vector<std::string>& words);

}  // namespace flatray
