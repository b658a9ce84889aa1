#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "app/help/help.h"
#include "app/help/version.h"
#include "app/interrupt.h"
#include "app/options/option_values.h"
#include "app/options/places.h"
#include "app/options/project_config.h"
#include "app/options/resource_limits.h"
#include "app/report/report.h"
#include "base/descriptor.h"
#include "base/entry_named.h"
#include "base/isa.h"
#include "base/left_out.h"
#include "base/module_file.h"
#include "base/shown_text.h"

namespace flatray {

#include "verbs.inc"  // all_verbs()

namespace {

// What all verbs have.
struct CommonOptions : Arguments {
  ResourceLimits limits;
  std::string root;
  bool sandbox = false;

  void rows(OptionTable& row, std::span<const Option> own) {
    if (!own.empty() && !has_own_root(own))
      row("--root DIR", "read and write nothing outside of this folder", root);
    if (!own.empty())
      row("--sandbox", "let the kernel refuse all other files: flatray help safety", sandbox);
    limits.rows(row);
    row("-h, --help", "show this");
  }
};

}  // namespace

std::size_t Verb::least_operands() const {
  const std::vector<std::string_view> shown = split(operands, ' ');
  return static_cast<std::size_t>(std::ranges::count_if(
      shown, [](std::string_view word) { return !word.empty() && !word.starts_with('['); }));
}

std::size_t Verb::most_operands() const {
  constexpr std::size_t kMany = 10'000;
  const std::string_view shown = operands;
  if (shown.find("...") != std::string_view::npos) return kMany;
  return hidden_operands + (shown.empty() ? 0 : split(shown, ' ').size());
}

std::vector<Option> options_of(const Verb& verb) {
  std::vector<Option> options = verb.command.options();
  OptionTable common;
  CommonOptions().rows(common, options);
  options.insert(options.end(), common.options().begin(), common.options().end());
  return options;
}

const Verb* find_verb(const std::string& name) { return entry_named(all_verbs(), name); }

namespace {

Diagnostics unknown_verb(const std::string& word) {
  if (const auto problem = if_left_out(named_place(word), "verb", word)) return {*problem};
  const std::vector<std::string> known = names_of(all_verbs());
  const std::string near = nearest_word(word, known);
  std::error_code ignored;
  std::string hint = fmt::format("say one of: {}", comma_list(known));
  if (word.starts_with('-')) hint = "the verb comes first, as in: flatray render SCENE --quiet";
  if (std::filesystem::exists(word, ignored))
    hint = fmt::format("flatray render {}", shell_word(word));
  return {{named_place(word),
           near.empty() ? "unknown verb" : fmt::format("unknown verb (did you mean {}?)", near),
           hint, Trouble::usage}};
}

// Standard output may be a full disk, too.
int print(const std::string& text, int code) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (written && std::fflush(stdout) == 0) return code;
  return report_failure(cannot("write", "standard output", errno, Trouble::output).value(), "");
}

// With all that is wrong with them but the values of options.
Arguments parse(const Verb& verb, const std::vector<std::string>& words) {
  const std::vector<Option> options = options_of(verb);
  Arguments parsed = parse_arguments(options, words, [](const char* name) {
    // Help in the environment would turn every render into a success that draws nothing.
    const bool asks_help = std::string_view(name) == "FLATRAY_HELP";
    return asks_help ? nullptr : static_cast<const char*>(std::getenv(name));
  });
  if (parsed.has("help")) return parsed;
  // What follows an unknown option may be its value.
  const std::size_t count =
      parsed.problems.empty() ? parsed.operands().size() : verb.least_operands();
  if (!verb.command.options().empty()) add_project_config(options, parsed);
  parsed.keep_one_format();
  const auto wrong = [&](std::string message) {
    parsed.problems.push_back({named_place(verb.name), std::move(message),
                               fmt::format("flatray {} {}", verb.name, verb.operands),
                               Trouble::usage});
  };
  if (count < verb.least_operands()) wrong(fmt::format("needs {}", verb.operands));
  if (const std::size_t most = verb.most_operands(); count > most)
    wrong(fmt::format("does not take '{}'", parsed.operands()[most]));
  check_root(verb, parsed);
  return parsed;
}

// Variables of the environment that mean nothing here, most likely misspelt.
Diagnostics unknown_variables() {
  std::vector<std::string> given;
  for (char** one = environ; one != nullptr && *one != nullptr; ++one)
    if (const std::string_view entry = *one; entry.starts_with("FLATRAY_"))
      given.emplace_back(entry.substr(0, entry.find('=')));
  if (given.empty()) return {};
  std::vector<std::string> known{"FLATRAY_ISA", "FLATRAY_HELP", "FLATRAY_WERROR",
                                 "FLATRAY_FULL_COUNTS"};
  for (const ModuleFile& module : kAllModules) known.emplace_back(module.variable);
  for (const Verb* verb : all_verbs())
    for (const Option& option : options_of(*verb)) known.push_back(environment_name(option));
  Diagnostics warnings;
  for (const std::string& name : given) {
    if (std::ranges::find(known, name) != known.end()) continue;
    const std::string near = nearest_word(name, known);
    warnings.push_back(
        {named_place(name), "no option is set by this variable",
         near.empty() ? "flatray help environment" : fmt::format("did you mean {}?", near)});
  }
  return warnings;
}

int answer(const Verb& verb, const std::vector<std::string>& words) {
  const Arguments arguments = parse(verb, words);
  Diagnostics problems = arguments.problems;
  if (arguments.has("help") && problems.empty()) return print(help_text(verb), 0);
  report_warnings(unknown_variables(), arguments);
  CommonOptions common;
  OptionTable table(arguments, problems);
  common.rows(table, verb.command.options());
  const Ready run = verb.command.read(arguments, problems);
  const auto failed = [&](const Diagnostics& why) {
    VerbOutput output{.results = failed_results(why)};
    return print(written(verb.name, arguments, output), report_failure(why, verb.undone));
  };
  if (!problems.empty()) return failed(problems);
  if (const auto entered = enter_sandbox(verb, arguments); !entered) return failed(entered.error());
  limit_resources(common.limits);
  Result<VerbOutput> output = run();
  if (!output) return failed(output.error());
  std::string text = written(verb.name, arguments, *output);
  if (!output->picture) text = shown_lines(std::move(text));
  const int code = print(text, output->exit_code);
  if (output->problems.empty() || code != output->exit_code) return code;
  return report_failure(output->problems, "what came before is told");
}

// Who stops a run, stops what goes on from it, too, even where all was done meanwhile.
int run_verb(const Verb& verb, const std::vector<std::string>& words) {
  catch_interrupts(verb.kept);
  const int code = answer(verb, words);
  if (!interrupted() || code > 1) return code;
  report_note(fmt::format("flatray: {}, when all was done", interruption()));
  return interrupted_code();
}

}  // namespace

int run_command_line(std::vector<std::string> words) {
  if (const Result<Isa> isa = chosen_isa(); !isa) return report_failure(isa.error(), "");
  if (words.empty()) {
    std::fputs(help_text().c_str(), stderr);
    return 2;
  }
  if (words.front() == "--help" || words.front() == "-h") words.front() = "help";
  const std::string first = words.front();
  if (first == "--version") return print(version_text(), 0);
  const Verb* verb = find_verb(first);
  if (verb == nullptr) return report_failure(unknown_verb(first), "");
  words.erase(words.begin());
  return run_verb(*verb, words);
}

}  // namespace flatray
