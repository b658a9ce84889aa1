#include <fmt/core.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "app/option_values.h"
#include "app/report.h"
#include "app/verb.h"
#include "app/version.h"
#include "base/isa.h"

namespace flatray {

#define FLATRAY_ENTRY(name) \
  namespace verbs {         \
  extern const Verb name;   \
  }
#include "verbs.inc"
#undef FLATRAY_ENTRY

std::vector<const Verb*> all_verbs() {
#define FLATRAY_ENTRY(name) &verbs::name,
  return {
#include "verbs.inc"
  };
#undef FLATRAY_ENTRY
}

namespace {

constexpr Option kHelp = {"help", 'h', "", "show this", OptionKind::flag};

const Verb* find_verb(const std::string& name) {
  for (const Verb* verb : all_verbs())
    if (name == verb->name) return verb;
  return nullptr;
}

Diagnostics unknown_verb(const std::string& word) {
  std::vector<std::string> known = {"help"};
  for (const Verb* verb : all_verbs()) known.emplace_back(verb->name);
  const std::string near = nearest_word(word, known);
  std::error_code ignored;
  std::string hint = fmt::format("say one of: {}", comma_list(known));
  if (word.starts_with('-')) hint = "the verb comes first, as in: flatray render SCENE --quiet";
  if (std::filesystem::exists(word, ignored)) hint = fmt::format("flatray render {}", word);
  return {{named_place(word),
           near.empty() ? "unknown verb" : fmt::format("unknown verb (did you mean {}?)", near),
           hint, Trouble::usage}};
}

// Standard output may be a full disk, too.
int print(const std::string& text, int code) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (written && std::fflush(stdout) == 0) return code;
  return report_failure({{named_place("standard output"), "cannot write", "", Trouble::output}},
                        "");
}

Result<Arguments> parse(const Verb& verb, std::vector<std::string> words) {
  std::vector<Option> options(verb.options.begin(), verb.options.end());
  options.push_back(kHelp);
  Result<Arguments> arguments = parse_arguments(options, std::move(words), [](const char* name) {
    // Help in the environment would turn every render into a success that draws nothing.
    const bool asks_help = std::string_view(name) == "FLATRAY_HELP";
    return asks_help ? nullptr : static_cast<const char*>(std::getenv(name));
  });
  if (!arguments || arguments->has("help")) return arguments;
  const std::size_t count = arguments->operands().size();
  const std::string hint = fmt::format("flatray {} {}", verb.name, verb.operands);
  if (count < verb.least_operands)
    return usage_error(named_place(verb.name), fmt::format("needs {}", verb.operands), hint);
  if (count > verb.most_operands)
    return usage_error(named_place(verb.name),
                       fmt::format("does not take '{}'", arguments->operands()[verb.most_operands]),
                       hint);
  return arguments;
}

int run_verb(const Verb& verb, std::vector<std::string> words) {
  const Result<Arguments> arguments = parse(verb, std::move(words));
  if (!arguments) return report_failure(arguments.error(), verb.undone);
  if (arguments->has("help")) return print(help_text(verb), 0);
  const Result<VerbOutput> output = verb.run(*arguments);
  if (!output) return report_failure(output.error(), verb.undone);
  return print(output->text, output->exit_code);
}

int run_help(const std::vector<std::string>& words) {
  if (words.size() < 2 || words[1] == "help") return print(help_text(), 0);
  const Verb* verb = find_verb(words[1]);
  if (verb == nullptr) return report_failure(unknown_verb(words[1]), "");
  return print(help_text(*verb), 0);
}

}  // namespace

std::string help_text() {
  std::string text =
      "flatray renders 2D scenes to pictures, exactly.\n\n"
      "  flatray VERB SCENE... [options]\n\n";
  for (const Verb* verb : all_verbs())
    text += fmt::format("  {:<11} {}\n", verb->name, verb->summary);
  return text +
         "  help        show the options of a verb: flatray help render\n\n"
         "flatray --version says what is built in. An option --size can also be set by "
         "FLATRAY_SIZE.\n"
         "Exit codes: 0 done, 1 the answer is no, 2 usage, 3 input missing, 4 input invalid,\n"
         "5 not in this build, 6 output not written, 70 internal, 130 interrupted.\n";
}

std::string help_text(const Verb& verb) {
  std::string text =
      fmt::format("flatray {} {} [options]\n\n{}.\n\n", verb.name, verb.operands, verb.summary);
  std::vector<Option> options(verb.options.begin(), verb.options.end());
  options.push_back(kHelp);
  for (const Option& option : options) {
    const std::string letter =
        option.letter == '\0' ? std::string("    ") : fmt::format("-{}, ", option.letter);
    const std::string name = fmt::format("--{} {}", option.name, option.metavar);
    text += fmt::format("  {}{:<24} {}\n", letter, name, option.help);
  }
  if (*verb.examples != '\0') text += fmt::format("\nExamples\n{}", verb.examples);
  return text;
}

int run_command_line(std::vector<std::string> words) {
  if (const Result<Isa> isa = chosen_isa(); !isa) return report_failure(isa.error(), "");
  if (words.empty()) {
    std::fputs(help_text().c_str(), stderr);
    return 2;
  }
  const std::string first = words.front();
  if (first == "--version") return print(version_text(), 0);
  if (first == "--help" || first == "-h" || first == "help") return run_help(words);
  const Verb* verb = find_verb(first);
  if (verb == nullptr) return report_failure(unknown_verb(first), "");
  words.erase(words.begin());
  return run_verb(*verb, std::move(words));
}

}  // namespace flatray
