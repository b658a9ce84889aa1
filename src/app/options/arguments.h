#pragma once
#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/entry_named.h"
#include "base/result.h"

namespace flatray {

enum class OptionKind : std::uint8_t {
  text,  ///< one value, given once
  list,  ///< one value each time it is given
  flag   ///< no value
};

/// Names known only at run time, for completion: those of the metrics in this build; or how files
/// end, each with its dot: ".png".
using Words = std::vector<std::string> (*)();

/// One option of a verb: what is parsed, shown by --help, suggested for a misspelt one and read
/// from the environment
/// (`--max-pixels` from FLATRAY_MAX_PIXELS) are all made of this row.
struct Option {
  std::string name;     ///< long name without dashes: "max-pixels"
  char letter;          ///< short name; '\0' for none
  std::string metavar;  ///< what stands for the value in the help: "N", "png|hdr"; "" for a flag
  std::string help;     ///< one line, no full stop
  OptionKind kind = OptionKind::text;
  Words words = nullptr;  ///< its values, where they are names or files

  /// Whether values of the command line, the environment and files go together, key by key.
  bool has_keys() const { return metavar == "KEY=VALUE"; }
};

/// The variable that stands for it: FLATRAY_MAX_PIXELS.
std::string environment_name(const Option& option);

/// What the user asked of one verb. Flags of the command line win over the environment.
class Arguments {
 public:
  struct Given {
    std::string origin;  ///< "--size" or "FLATRAY_SIZE": the place messages name
    std::vector<std::string> values;
    Place place{};  ///< where it is written, in a file
    /// Of the first values, where these are said elsewhere.
    std::vector<Place> places{};

    Place where() const { return place ? place : named_place(origin); }
    Place where(std::size_t value) const { return value < places.size() ? places[value] : where(); }
    /// Values said farther away come first, but for those KEY=VALUE whose key has a value here.
    void add_farther(const Given& farther);
  };

  Arguments() = default;
  Arguments(std::map<std::string, Given, std::less<>> given, std::vector<std::string> operands)
      : given_(std::move(given)), operands_(std::move(operands)) {}

  /// Scenes, files, names: what is not an option, in order.
  const std::vector<std::string>& operands() const { return operands_; }
  /// Everything given, by option name.
  const std::map<std::string, Given, std::less<>>& given() const { return given_; }

  /// When they were read: the time a verb takes counts from here.
  std::chrono::steady_clock::time_point read_at() const { return read_at_; }

  bool has(std::string_view name) const { return find(name) != nullptr; }
  /// What is given to an option; null for nothing.
  const Given* find(std::string_view name) const {
    const auto found = given_.find(name);
    return found == given_.end() ? nullptr : &found->second;
  }
  /// Whether it is given for this command: what files and the environment say is for all of them.
  bool is_asked(std::string_view name) const {
    const Given* given = find(name);
    return given != nullptr && given->origin.starts_with("--");
  }
  /// Value of a text option, if given.
  std::optional<std::string> text(std::string_view name) const;
  /// Values of a list option in order.
  std::vector<std::string> list(std::string_view name) const;
  /// Where an option's value comes from, for messages.
  Place where(std::string_view name) const;

  /// Gives an option more values, nearer than those it has or farther.
  void add_nearer(const std::string& name, Given given);
  void add_farther(const std::string& name, const Given& given);
  /// Where two ways to print are given, the one said nearer counts: the command line before the
  /// environment, and this before a file. Two said alike are a mistake.
  void keep_one_format();

  /// Flags that the environment says no to, which a file does not set.
  std::set<std::string, std::less<>> denied{};
  /// What is wrong with the words, to be told with what is wrong with their values.
  Diagnostics problems{};
  /// Told so far (report_warnings of app/report/report.h); those of all copies are the same.
  std::shared_ptr<Diagnostics> warnings = std::make_shared<Diagnostics>();

 private:
  std::map<std::string, Given, std::less<>> given_;
  std::vector<std::string> operands_;
  std::chrono::steady_clock::time_point read_at_ = std::chrono::steady_clock::now();
};

/// Reads the words after the verb. Options and operands may stand in any order; `--` ends the
/// options.
///
/// Gives   options of the command line, then for those absent FLATRAY_<NAME> of `environment` (a
///         flag is set by 1, true, yes or on, and not by 0, false, no, off; empty counts as unset).
///         Its `problems`: unknown options with the nearest known one, missing values, options
///         given twice.
using Environment = const char* (*)(const char* name);
Arguments parse_arguments(std::span<const Option> options, const std::vector<std::string>& words,
                          Environment environment);

/// A failed Result with Trouble::usage.
inline tl::unexpected<Diagnostics> usage_error(Place where, std::string message,
                                               std::string hint = {}) {
  return fail(std::move(where), std::move(message), std::move(hint), Trouble::usage);
}

/// " (did you mean 'near'?)", or "".
std::string did_you_mean(std::string_view word, const std::vector<std::string>& known);
/// Trouble::usage: "no WHAT is called 'word' (did you mean 'near'?)", and all of `known`.
tl::unexpected<Diagnostics> unknown_name(Place where, const char* what, const std::string& word,
                                         const std::vector<std::string>& known);

/// The names between commas, each once. Error   those that are not known.
Result<std::vector<std::string>> chosen_names(std::string_view text, const Place& where,
                                              const char* what,
                                              const std::vector<std::string>& known);

/// The number of a word among those known.
/// Error   Trouble::usage with the nearest one.
Result<std::size_t> word_of(const std::string& text, const Place& where,
                            const std::vector<std::string>& known);

/// Reads a name: to which of the registered entries it points. Error   a name that is not known.
template <class Entries>
auto entry_called(const char* what, const Entries& entries) {
  return [=](const std::string& name, const Place& where) -> Result<decltype(&*entries.front())> {
    for (const auto& entry : entries)
      if (name == entry->name) return &*entry;
    return unknown_name(where, what, name, names_of(entries));
  };
}

/// Reads names between commas, each once. Error   the names that are not known.
inline auto names_among(const char* what, const std::vector<std::string>& known) {
  return [=](const std::string& text, const Place& where) {
    return chosen_names(text, where, what, known);
  };
}

}  // namespace flatray
