#pragma once
#include <concepts>
#include <functional>
#include <initializer_list>
#include <memory>

#include "app/options/arguments.h"
#include "scene/reading/reader.h"

namespace flatray {

/// A range and a default as the help shows them: " (1 to 2^40, default 1000)".
std::string range_text(std::uint64_t low, std::uint64_t high, const std::string& otherwise);
/// What a member is before it is read, for the help; "" for what says nothing.
std::string default_text(double value);
inline std::string default_text(std::uint64_t value) { return std::to_string(value); }
inline std::string default_text(unsigned value) { return std::to_string(value); }
inline std::string default_text(const std::string& value) { return value; }
template <class T>
std::string default_text(const T&) {
  return {};
}

/// A whole number in [low, high].
/// Error   Trouble::usage.
Result<std::uint64_t> whole_of(const std::string& text, const Place& where, std::uint64_t low,
                               std::uint64_t high);

/// Gives a text as it is.
inline Result<std::string> as_text(const std::string& text, const Place&) { return text; }

/// A row without a value of its own, which several verbs have.
struct SharedRow {
  const char *spelling, *help;
  Words words = nullptr;
};

/// The options of a verb: each row says how one is written, what it is for, and which member takes
/// its value. All else comes from the rows: help, completion, environment, flatray.toml, defaults
/// and messages. A struct of options has one function that tells its rows,
///
///     void rows(OptionTable& row) {
///       row("-n, --bounces N", "most bounces, instead of the ray's own", bounces, 0,
///       kMostBounces);
///     }
///
/// which is called to list them and to read them: what the member is before is the default. As the
/// keys of scenes, each is read whatever is wrong with others, so that all mistakes are told
/// together.
class OptionTable {
 public:
  /// Lists the rows.
  OptionTable() = default;
  /// Reads them. Mistakes go to `problems`.
  OptionTable(const Arguments& given, Diagnostics& problems)
      : given_(&given), problems_(&problems) {}

  const std::vector<Option>& options() const { return options_; }
  /// Whether it is given, when rows are read.
  bool has(std::string_view name) const { return given_ != nullptr && given_->has(name); }
  bool is_asked(std::string_view name) const { return given_ != nullptr && given_->is_asked(name); }
  /// The operand of that number; "" where there is none or rows are listed.
  std::string operand(std::size_t index) const;

  /// A row whose value is read later, by `read`.
  void operator()(const char* spelling, std::string help, Words words = nullptr);
  void operator()(const SharedRow& shared) { (*this)(shared.spelling, shared.help, shared.words); }
  /// A flag.
  void operator()(const char* spelling, std::string help, bool& member);
  /// Text as it is.
  template <class M>
  requires std::same_as<M, std::string> || std::same_as<M, std::optional<std::string>>
  void operator()(const char* spelling, const std::string& help, M& member) {
    (*this)(spelling, help, member, &as_text);
  }

  /// A whole number in [low, high].
  template <class M>
  void operator()(const char* spelling, const std::string& help, M& member, std::uint64_t low,
                  std::uint64_t high) {
    (*this)(spelling, help + range_text(low, high, default_text(member)));
    read(options_.back().name, member, [&](const std::string& text, const Place& where) {
      return whole_of(text, where, low, high).map([](std::uint64_t value) {
        return static_cast<decltype(held(member))>(value);
      });
    });
  }

  /// One of some words, which the row shows: `spelling` names none.
  template <class M, class E, std::size_t n>
  void operator()(const std::string& spelling, std::string help, M& member,
                  const Word<E> (&words)[n]) {
    std::vector<std::string> known;
    std::string shown, otherwise;
    for (const auto& [word, value] : words) {
      known.emplace_back(word);
      shown += (shown.empty() ? "" : "|") + known.back();
      if (otherwise.empty() && member == value) otherwise = fmt_default(word);
    }
    (*this)((spelling + " " + shown).c_str(), std::move(help) + otherwise);
    read(options_.back().name, member, [&](const std::string& text, const Place& where) {
      return word_of(text, where, known).map([&](std::size_t i) { return words[i].second; });
    });
  }

  /// What `take(text, place)` makes of it.
  template <class M, std::invocable<const std::string&, const Place&> Take>
  void operator()(const char* spelling, const std::string& help, M& member, const Take& take,
                  Words words = nullptr) {
    const std::string otherwise = default_text(member);
    (*this)(spelling, otherwise.empty() ? help : help + fmt_default(otherwise), words);
    read(options_.back().name, member, take);
  }

  /// The same of a row told before, where it depends on others.
  template <class M, std::invocable<const std::string&, const Place&> Take>
  void read(std::string_view name, M& member, const Take& take) {
    if (!has(name)) return;
    if (auto result = take(*given_->text(name), given_->where(name)))
      member = *std::move(result);
    else
      keep(result.error());
  }

  /// An option that may be given many times: each value as `take` makes it.
  template <class M, std::invocable<const std::string&, const Place&> Take>
  void each(const char* spelling, std::string help, std::vector<M>& members, const Take& take) {
    (*this)(spelling, std::move(help));
    options_.back().kind = OptionKind::list;
    const auto given = given_ == nullptr ? nullptr : given_->find(options_.back().name);
    for (std::size_t i = 0; given != nullptr && i < given->values.size(); ++i)
      if (auto result = take(given->values[i], given->where(i)))
        members.push_back(*std::move(result));
      else
        keep(result.error());
  }

  /// A mistake that the values of several options are together; none where rows are listed.
  void problem(std::string_view name, std::string message, std::string hint = {});
  /// None of the others goes with `name`.
  void excludes(std::string_view name, std::initializer_list<const char*> others);
  /// What a function of options says against them.
  void keep(const Diagnostics& problems);

 private:
  // The type of what a member holds.
  template <class T>
  static T held(const T& member);
  template <class T>
  static T held(const std::optional<T>& member);

  static std::string fmt_default(const std::string& value) { return " (default " + value + ")"; }

  std::vector<Option> options_;
  const Arguments* given_ = nullptr;
  Diagnostics* problems_ = nullptr;
};

/// A read struct of options, whose base is what was given. Mistakes go to `problems`.
template <class Options>
std::shared_ptr<Options> read_options(Arguments given, Diagnostics& problems) {
  auto options = std::make_shared<Options>();
  static_cast<Arguments&>(*options) = std::move(given);
  OptionTable table(*options, problems);
  options->rows(table);
  return options;
}

struct VerbOutput;
/// A verb that has read its options.
using Ready = std::function<Result<VerbOutput>()>;

/// How a verb's options are listed, and read for it to run. What is read with mistakes must not
/// run.
struct Command {
  std::vector<Option> (*options)();
  Ready (*read)(Arguments given, Diagnostics& problems);
};

/// That of a function of a struct of options.
template <class Options, Result<VerbOutput> (*run)(const Options&)>
inline constexpr Command kCommand = {
    [] {
      OptionTable table;
      Options().rows(table);
      return table.options();
    },
    [](Arguments given, Diagnostics& problems) -> Ready {
      return
          [options = read_options<Options>(std::move(given), problems)] { return run(*options); };
    }};

/// For verbs that have none of their own.
struct NoOptions : Arguments {
  void rows(OptionTable&) {}
};

}  // namespace flatray
