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
  const Given* found = find(name);
  return found == nullptr ? std::nullopt : std::optional(found->values.front());
}

std::vector<std::string> Arguments::list(std::string_view name) const {
  const Given* found = find(name);
  return found == nullptr ? std::vector<std::string>{} : found->values;
}

Place Arguments::where(std::string_view name) const {
  const Given* found = find(name);
  return found == nullptr ? named_place(fmt::format("--{}", name)) : found->where();
}

void Arguments::Given::add_farther(const Given& farther) {
  if (values.empty()) {
    *this = farther;
    return;
  }
  for (std::size_t i = farther.values.size(); i-- > 0;) {
    const std::string& value = farther.values[i];
    const std::string key = value.substr(0, value.find('=')) + "=";
    if (std::ranges::any_of(values, [&](const auto& one) { return one.starts_with(key); }))
      continue;
    values.insert(values.begin(), value);
    places.insert(places.begin(), farther.where(i));
  }
}

void Arguments::add_nearer(const std::string& name, Given given) {
  Given& one = given_[name];
  given.add_farther(one);
  one = std::move(given);
}

void Arguments::add_farther(const std::string& name, const Given& given) {
  given_[name].add_farther(given);
}

void Arguments::keep_one_format() {
  std::vector<const char*> nearest;
  int least = 3;
  for (const char* format : {"json", "csv", "svg"}) {
    const auto found = given_.find(format);
    if (found == given_.end()) continue;
    const int distance = found->second.origin.starts_with("--") ? 0 : found->second.place ? 2 : 1;
    if (distance < least) nearest.clear();
    if (distance <= least) nearest.push_back(format);
    least = std::min(least, distance);
  }
  for (const char* format : {"json", "csv", "svg"})
    if (std::ranges::find(nearest, format) == nearest.end()) given_.erase(format);
  for (std::size_t i = 1; i < nearest.size(); ++i)
    problems.push_back({where(nearest[i]), fmt::format("does not go with --{}", nearest[0]),
                        "each is all that is printed: leave one of them out", Trouble::usage});
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& known) {
  const std::string near = nearest_word(word, known);
  return near.empty() ? "" : fmt::format(" (did you mean '{}'?)", near);
}

Result<std::size_t> word_of(const std::string& text, const Place& where,
                            const std::vector<std::string>& known) {
  const auto found = std::ranges::find(known, text);
  if (found != known.end()) return static_cast<std::size_t>(found - known.begin());
  return usage_error(where, fmt::format("unknown value '{}'{}", text, did_you_mean(text, known)),
                     fmt::format("say {}", comma_list(known)));
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
  return usage_error(std::move(where),
                     fmt::format("no {} is called '{}'{}", what, word, did_you_mean(word, known)),
                     known.empty() ? "there is none" : "there are: " + listed(known));
}

Result<std::vector<std::string>> chosen_names(std::string_view text, const Place& where,
                                              const char* what,
                                              const std::vector<std::string>& known) {
  std::vector<std::string> names;
  for (const std::string_view word : split(text, ',')) {
    if (std::ranges::find(known, word) == known.end())
      return unknown_name(where, what, std::string(word), known);
    if (std::ranges::find(names, word) == names.end()) names.emplace_back(word);
  }
  return names;
}

}  // namespace flatray
