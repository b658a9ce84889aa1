#include "app/options/arguments.h"

#include <fmt/core.h>

#include <algorithm>

#include "app/options/option_values.h"
#include "base/left_out.h"

namespace flatray {

std::string environment_name(const Option& option) {
  std::string name = fmt::format("FLATRAY_{}", option.name);
  for (char& c : name) c = c == '-' ? '_' : static_cast<char>(std::toupper(c));
  return name;
}

std::optional<std::string> Arguments::text(std::string_view name) const {
  const auto found = given_.find(name);
  if (found == given_.end()) return std::nullopt;
  return found->second.values.front();
}

std::vector<std::string> Arguments::list(std::string_view name) const {
  const auto found = given_.find(name);
  return found == given_.end() ? std::vector<std::string>{} : found->second.values;
}

Place Arguments::where(std::string_view name) const {
  const auto found = given_.find(name);
  if (found == given_.end()) return named_place(fmt::format("--{}", name));
  return found->second.place ? found->second.place : named_place(found->second.origin);
}

Result<std::uint64_t> Arguments::whole(std::string_view name, std::uint64_t otherwise,
                                       std::uint64_t low, std::uint64_t high) const {
  const std::optional<std::string> given = text(name);
  if (!given) return otherwise;
  const std::optional<std::uint64_t> value = parse_whole(*given);
  if (!value)
    return usage_error(where(name), fmt::format("'{}' is not a whole number", *given),
                       fmt::format("say a number from {} to {}", low, high));
  if (*value < low || *value > high)
    return usage_error(where(name), fmt::format("{} is out of range", *given),
                       fmt::format("say a number from {} to {}", low, high));
  return *value;
}

Result<std::string> Arguments::one_of(std::string_view name,
                                      const std::vector<std::string>& words) const {
  const std::string given = text(name).value_or(words.front());
  if (std::find(words.begin(), words.end(), given) != words.end()) return given;
  const std::string near = nearest_word(given, words);
  return usage_error(where(name),
                     fmt::format("unknown value '{}'{}", given,
                                 near.empty() ? "" : fmt::format(" (did you mean '{}'?)", near)),
                     fmt::format("say {}", comma_list(words)));
}

namespace {

// As many as `help` has topics are listed; of more, as the entities of a scene, the first few.
std::string listed(std::vector<std::string> known) {
  constexpr std::size_t kMostListed = 80, kFirst = 3;
  if (known.size() <= kMostListed) return comma_list(known);
  const std::size_t more = known.size() - kFirst;
  known.resize(kFirst);
  return fmt::format("{} and {} more", comma_list(known), more);
}

}  // namespace

tl::unexpected<Diagnostics> unknown_name(Place where, const char* what, const std::string& word,
                                         const std::vector<std::string>& known) {
  if (const auto problem = if_left_out(where, what, word))
    return tl::unexpected(Diagnostics{*problem});
  const std::string near = nearest_word(word, known);
  return usage_error(std::move(where),
                     fmt::format("no {} is called '{}'{}", what, word,
                                 near.empty() ? "" : fmt::format(" (did you mean '{}'?)", near)),
                     known.empty() ? "there is none" : "there are: " + listed(known));
}

Result<std::vector<std::string>> chosen_names(const Arguments& arguments, const char* option,
                                              const char* what,
                                              const std::vector<std::string>& known) {
  const auto text = arguments.text(option);
  if (!text) return known;
  std::vector<std::string> names;
  for (const std::string_view word : split(*text, ',')) {
    if (std::find(known.begin(), known.end(), word) == known.end())
      return unknown_name(arguments.where(option), what, std::string(word), known);
    if (std::find(names.begin(), names.end(), word) == names.end()) names.emplace_back(word);
  }
  return names;
}

}  // namespace flatray
