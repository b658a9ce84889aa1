#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace flatray {

/// What may stand for the last of some words of a command line.
struct Completion {
  struct Candidate {
    std::string word, summary;
  };
  std::vector<Candidate> candidates;    ///< that begin as the last word does
  std::vector<std::string> extensions;  ///< files with these are wanted, too
  bool folders = false;                 ///< folders are wanted, too
};

/// Completes the last of `words`; the first is the program's name. Verbs, options and values are
/// those of the tables that parse: there is no second list. Names of a scene's entities and rays
/// come from the scene that stands among the words, if it can be read.
Completion complete(const std::vector<std::string>& words);

/// For the scripts: a line for each candidate, its summary after a tab; then, after a tab that no
/// candidate begins with, "files EXT..." and "folders". Candidates are bare: quoting them for the
/// shell is the script's part, for they hold what a scene says.
std::string completion_lines(const Completion& completion);

/// Script that a shell sources; "" for a shell there is none for.
std::string completion_script(std::string_view shell);
std::vector<std::string> completed_shells();

}  // namespace flatray
