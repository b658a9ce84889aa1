// The only file that includes CLI11, which takes seconds to compile. It splits words into options
// and operands; what they mean is ours.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <deque>

#include "app/options/arguments.h"

namespace flatray {
namespace {

using Given = Arguments::Given;

// What CLI11 writes into while it parses; a deque, since it keeps references.
struct Slot {
  const Option* option;
  std::vector<std::string> values;
  CLI::Option* parsed;
};

std::string spelling(const Option& option) {
  return option.letter == '\0' ? fmt::format("--{}", option.name)
                               : fmt::format("-{},--{}", option.letter, option.name);
}

std::deque<Slot> declare(CLI::App& parser, std::span<const Option> options,
                         std::vector<std::string>& operands) {
  parser.set_help_flag();
  parser.allow_extras();
  std::deque<Slot> slots;
  for (const Option& option : options) {
    Slot& slot = slots.emplace_back(Slot{&option, {}, nullptr});
    if (option.kind == OptionKind::flag)
      slot.parsed = parser.add_flag(spelling(option))->disable_flag_override();
    else
      slot.parsed = parser.add_option(spelling(option), slot.values)
                        ->expected(1)
                        ->allow_extra_args(false)
                        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  }
  parser.add_option("operands", operands);
  return slots;
}

std::string long_name(const Option& option) { return fmt::format("--{}", option.name); }

Diagnostic unknown_option(const std::string& word, std::span<const Option> options) {
  const std::string bare = word.substr(0, word.find('='));
  std::vector<std::string> known;
  for (const Option& option : options) known.push_back(long_name(option));
  const std::string near = nearest_word(bare, known);
  return {named_place(bare),
          near.empty() ? "unknown option" : fmt::format("unknown option (did you mean {}?)", near),
          "", Trouble::usage};
}

// nullopt: the word means neither yes nor no.
std::optional<bool> truth(const std::string& word) {
  for (const char* yes : {"1", "true", "yes", "on"})
    if (word == yes) return true;
  for (const char* no : {"0", "false", "no", "off"})
    if (word == no) return false;
  return std::nullopt;
}

void read_environment(const Option& option, Environment environment,
                      std::map<std::string, Given, std::less<>>& given, Diagnostics& problems) {
  const std::string name = environment_name(option);
  const char* value = environment(name.c_str());
  if (value == nullptr || *value == '\0' || given.count(option.name) != 0) return;
  if (option.kind == OptionKind::flag) {
    const std::optional<bool> set = truth(value);
    if (!set)
      problems.push_back({named_place(name), fmt::format("'{}' is neither yes nor no", value),
                          "say 1 or 0", Trouble::usage});
    if (set.value_or(false)) given[option.name] = {name, {}};
    return;
  }
  given[option.name] = {name, {value}};
}

// A value that is itself an option was most likely meant as one: `-o --quiet`.
bool is_option(const std::string& word, std::span<const Option> options) {
  return std::any_of(options.begin(), options.end(),
                     [&](const Option& option) { return word == long_name(option); });
}

void check_slot(const Slot& slot, std::span<const Option> options, Diagnostics& problems) {
  const Place where = named_place(long_name(*slot.option));
  for (const std::string& value : slot.values)
    if (is_option(value, options))
      problems.push_back(
          {where, fmt::format("needs a value {}, not the option {}", slot.option->metavar, value),
           "", Trouble::usage});
  if (slot.option->kind == OptionKind::text && slot.values.size() > 1)
    problems.push_back({where,
                        fmt::format("is given {} times: '{}' and '{}'", slot.values.size(),
                                    slot.values[0], slot.values[1]),
                        "say it once", Trouble::usage});
}

// What CLI11 says when it stops, in our words: its own begin with the option.
tl::unexpected<Diagnostics> not_divided(const std::deque<Slot>& slots,
                                        const CLI::ParseError& error) {
  const std::string what = error.what();
  for (const Slot& slot : slots) {
    const std::string name = slot.option->name;
    if (what.starts_with(long_name(*slot.option) + ":"))
      return usage_error(named_place(long_name(*slot.option)),
                         fmt::format("needs a value {}", slot.option->metavar),
                         fmt::format("say --{} {}", name, slot.option->metavar));
    if (what.starts_with(name + " "))
      return usage_error(named_place(long_name(*slot.option)), "takes no value",
                         fmt::format("say --{} alone, or leave it out", name));
  }
  return usage_error({}, what);
}

}  // namespace

Result<Arguments> parse_arguments(std::span<const Option> options, std::vector<std::string> words,
                                  Environment environment) {
  CLI::App parser;
  std::vector<std::string> operands;
  std::deque<Slot> slots = declare(parser, options, operands);
  std::reverse(words.begin(), words.end());  // as CLI11 wants them
  try {
    parser.parse(std::move(words));
  } catch (const CLI::ParseError& error) {  // CLI11 reports no other way
    return not_divided(slots, error);
  }
  Diagnostics problems;
  for (const std::string& word : parser.remaining())
    if (word != "--")  // CLI11 counts it among what it does not know
      problems.push_back(unknown_option(word, options));
  std::map<std::string, Given, std::less<>> given;
  for (Slot& slot : slots) {
    check_slot(slot, options, problems);
    if (slot.parsed->count() > 0)
      given[slot.option->name] = {long_name(*slot.option), std::move(slot.values)};
    read_environment(*slot.option, environment, given, problems);
  }
  if (!problems.empty()) return tl::unexpected(std::move(problems));
  return Arguments(std::move(given), std::move(operands));
}

}  // namespace flatray
