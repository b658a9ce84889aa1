#pragma once
#include <string>
#include <vector>

#include "base/source_text.h"

namespace flatray {

/// What went wrong decides the exit code (docs/LIMITS.md); a library never exits by itself.
enum class Trouble {
  usage,        ///< the command line is wrong: exit 2
  missing,      ///< an input is not there or cannot be read: exit 3
  invalid,      ///< an input is read but wrong: exit 4
  unavailable,  ///< a back end or optional part is not in this build: exit 5
  output,       ///< a result could not be written: exit 6
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

}  // namespace flatray
