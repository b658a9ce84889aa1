#pragma once
#include <span>
#include <string>
#include <vector>

#include "app/arguments.h"

namespace flatray {

/// What a verb that ran has to say: data for standard output, and 0, 1 (the answer is no) or 130
/// (interrupted). Mistakes are the failed Result instead; their Trouble decides the exit code.
struct VerbOutput {
  std::string text;
  int exit_code = 0;
  Diagnostics problems{};  ///< that end the answer: told after it, as those of a failed Result
};

/// One word of the command line after `flatray`. Options every verb has (--help) are added to its
/// own.
struct Verb {
  const char* name;
  const char* operands;  ///< as shown in the usage line: "SCENE..."
  const char* summary;   ///< one line, no full stop
  std::size_t least_operands, most_operands;
  std::span<const Option> options;
  const char* examples;  ///< lines of `flatray help VERB`, "" for none
  const char* undone;    ///< what a failure leaves: "nothing rendered", "" for nothing to say
  Result<VerbOutput> (*run)(const Arguments&);
  Words words = nullptr;  ///< what the first operand may be, where that is a list of names
};

/// Registered verbs by name: one file each in app/verbs, defining `const Verb <name>` in namespace
/// flatray::verbs.
std::vector<const Verb*> all_verbs();

/// Runs the command line `words` (without the program's name): finds the verb, parses, runs, prints
/// data to standard output and mistakes to standard error. Gives   the exit code (design, section
/// 3).
int run_command_line(std::vector<std::string> words);

}  // namespace flatray
