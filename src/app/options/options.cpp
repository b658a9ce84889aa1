// Tells options from operands among the words of a command line, as GNU programs do.
#include <fmt/core.h>

#include <algorithm>

#include "app/options/arguments.h"

namespace flatray {
namespace {

using Given = Arguments::Given;

std::string long_name(const Option& option) { return fmt::format("--{}", option.name); }

class WordReader {
 public:
  explicit WordReader(std::span<const Option> options) : options_(options) {}

  void read(const std::vector<std::string>& words) {
    for (next_ = words.begin(), end_ = words.end(); next_ != end_;) {
      const std::string& word = *next_++;
      if (word == "--") {
        operands.insert(operands.end(), next_, end_);
        next_ = end_;
      } else if (word.empty()) {
        wrong("''", "is empty", "name what is meant");
      } else if (word.size() < 2 || word[0] != '-') {
        operands.push_back(word);
      } else if (word[1] == '-') {
        read_long(word);
      } else {
        read_letters(word);
      }
    }
  }

  void read(const Option& option, const std::string& variable, const std::string& value) {
    if (value.empty() || (given.contains(option.name) && !option.has_keys())) return;
    const auto is_one_of = [&](std::initializer_list<const char*> words) {
      return std::ranges::find(words, value) != words.end();
    };
    if (option.kind != OptionKind::flag)
      given[option.name].add_farther({variable, {value}});
    else if (is_one_of({"1", "true", "yes", "on"}))
      given[option.name] = {variable, {}};
    else if (is_one_of({"0", "false", "no", "off"}))
      denied.insert(option.name);
    else
      wrong(variable, fmt::format("'{}' is neither yes nor no", value), "say 1 or 0");
  }

  std::map<std::string, Given, std::less<>> given;
  std::set<std::string, std::less<>> denied;
  std::vector<std::string> operands;
  Diagnostics problems;

 private:
  void wrong(const std::string& where, std::string message, std::string hint = {}) {
    problems.push_back({named_place(where), std::move(message), std::move(hint), Trouble::usage});
  }

  template <class Fits>
  const Option* find(const Fits& fits) const {
    const auto found = std::ranges::find_if(options_, fits);
    return found == options_.end() ? nullptr : &*found;
  }
  const Option* named(std::string_view word) const {
    return find([&](const Option& option) { return long_name(option) == word; });
  }

  void read_long(const std::string& word) {
    const std::size_t equals = word.find('=');
    const Option* option = named(word.substr(0, equals));
    if (option == nullptr) return unknown(word.substr(0, equals));
    if (equals == std::string::npos) return give(*option, std::nullopt);
    give(*option, word.substr(equals + 1));
  }

  // "-q", "-qf3", "-f 3".
  void read_letters(const std::string& word) {
    for (std::size_t i = 1; i < word.size(); ++i) {
      const Option* option = find([&](const Option& one) { return one.letter == word[i]; });
      if (option == nullptr) return unknown(word.substr(0, word.find('=')));
      const bool flag = option->kind == OptionKind::flag;
      give(*option,
           flag || i + 1 == word.size() ? std::nullopt : std::optional(word.substr(i + 1)));
      if (!flag) return;
    }
  }

  void unknown(const std::string& word) {
    std::vector<std::string> known;
    for (const Option& option : options_) known.push_back(long_name(option));
    const std::string near = nearest_word(word, known);
    if (near.empty()) return wrong(word, "unknown option", "--help lists those there are");
    wrong(word, fmt::format("unknown option (did you mean {}?)", near));
  }

  void give(const Option& option, std::optional<std::string> value) {
    const std::string name = long_name(option);
    if (option.kind == OptionKind::flag) {
      if (value) wrong(name, "takes no value", fmt::format("say {} alone, or leave it out", name));
      given[option.name] = {name, {}};
      return;
    }
    const std::string needed = fmt::format("needs a value {}", option.metavar);
    if (!value && next_ == end_)
      return wrong(name, needed, fmt::format("say {} {}", name, option.metavar));
    // One that is itself an option was most likely meant as one: `-o --quiet`.
    if (const std::string& text = value ? *value : *next_; named(text) != nullptr)
      return wrong(name, fmt::format("{}, not the option {}", needed, text));
    if (!value) value = *next_++;
    if (value->empty())
      return wrong(name, "is empty",
                   fmt::format("say {} {}, or leave it out", name, option.metavar));
    if (*value == "-" && option.metavar == std::string_view("FOLDER"))
      wrong(name, "is a folder, which standard output is not", "name one; ./- is one called -");
    Given& one = given.try_emplace(option.name, Given{name, {}}).first->second;
    one.values.push_back(*std::move(value));
    if (option.kind == OptionKind::text && one.values.size() == 2)
      wrong(name, fmt::format("is given 2 times: '{}' and '{}'", one.values[0], one.values[1]),
            "say it once");
  }

  std::span<const Option> options_;
  std::vector<std::string>::const_iterator next_, end_;
};

}  // namespace

Arguments parse_arguments(std::span<const Option> options, const std::vector<std::string>& words,
                          Environment environment) {
  WordReader reader(options);
  reader.read(words);
  for (const Option& option : options) {
    const std::string variable = environment_name(option);
    if (const char* value = environment(variable.c_str())) reader.read(option, variable, value);
  }
  Arguments arguments(std::move(reader.given), std::move(reader.operands));
  arguments.denied = std::move(reader.denied);
  arguments.problems = std::move(reader.problems);
  return arguments;
}

}  // namespace flatray
