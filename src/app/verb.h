#pragma once
#include <string>
#include <vector>

#include "app/options/option_table.h"
#include "app/report/report.h"

namespace flatray {

/// One word of the command line after `flatray`. Options every verb has (--help) are added to its
/// own.
struct Verb {
  const char* name;
  const char* operands;  ///< as shown in the usage line, and how many: "SCENE...", "[KIND]"
  const char* summary;   ///< one line, no full stop
  Command command;
  const char* examples;     ///< lines of `flatray help VERB`, "" for none
  const char* undone = "";  ///< what a failure leaves: "nothing rendered", "" for nothing to say
  Words words = nullptr;    ///< what the first operand may be, where that is a list of names, or
                            ///< how files end that all of them may be
  /// What a stopped run leaves for another to go on from; null: nothing, so it is stopped at once.
  const char* kept = nullptr;
  std::size_t hidden_operands = 0;  ///< at most, beside those shown

  std::size_t least_operands() const;
  std::size_t most_operands() const;
};

/// Its own options and those that every verb has: --root, --sandbox where it has any,
/// --max-seconds, --max-memory, --help.
std::vector<Option> options_of(const Verb& verb);

/// Registered verbs by name: one file each in app/verbs, defining `const Verb entry` in namespace
/// flatray::<name>_verb.
std::vector<const Verb*> all_verbs();

/// The verb of a name; null where there is none.
const Verb* find_verb(const std::string& name);

/// Runs the command line `words` (without the program's name): finds the verb, parses, runs, prints
/// data to standard output and mistakes to standard error. Gives   the exit code
/// (docs/LIMITS.md).
int run_command_line(std::vector<std::string> words);

}  // namespace flatray
