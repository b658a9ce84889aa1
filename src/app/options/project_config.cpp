#include "app/options/project_config.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "app/options/places.h"
#include "base/beneath.h"
#include "base/file.h"
#include "scene/reading/format.h"
#include "scene/reading/vocabulary.h"

namespace flatray {
namespace {

constexpr std::size_t kMostConfigBytes = std::size_t{1} << 20;

std::vector<std::string> all_options() {
  std::set<std::string> names;
  for (const Verb* verb : all_verbs())
    for (const Option& option : options_of(*verb)) names.insert(option.name);
  names.erase("help");
  return {names.begin(), names.end()};
}

// One value as the command line would have it; nullopt for what is none.
std::optional<std::string> text_of(const Value& value) {
  if (value.kind == Value::Kind::number) return std::string(source_text(value));
  if (value.kind == Value::Kind::string) return value.text;
  return std::nullopt;
}

// What a key of that option gives; nullopt for a flag that is not set.
Result<std::optional<std::vector<std::string>>> values_of(const Option& option,
                                                          const Value& value) {
  const auto is_not = [&](const char* expected) {
    return fail(value.where,
                fmt::format("{} is {}, not {}", option.name, kind_name(value.kind), expected),
                "write it as on the command line, without the dashes");
  };
  std::vector<std::string> texts;
  if (option.kind == OptionKind::flag) {
    if (value.kind != Value::Kind::boolean) return is_not("true or false");
    return value.text == "true" ? std::optional(texts) : std::nullopt;
  }
  const bool is_list = option.kind == OptionKind::list && value.kind == Value::Kind::array;
  for (const Value& item : is_list ? std::span(value.items) : std::span(&value, 1)) {
    const std::optional<std::string> text = text_of(item);
    if (!text) return is_not(is_list ? "a list of strings" : "a number or string");
    // Whoever wrote the folder is not the one who runs a program in it.
    if (names_path(option.metavar) && !path_beneath(folder_of(kProjectConfig), *text))
      return fail(value.where,
                  fmt::format("{} is '{}', outside of this folder", option.name, *text),
                  fmt::format("say --{} {} on the command line", option.name, *text));
    texts.push_back(*text);
  }
  return texts;
}

// With the place of each item of a list.
Arguments::Given given_by(const Value& value, std::vector<std::string> texts) {
  Arguments::Given given{kProjectConfig, std::move(texts), value.where};
  for (const Value& item : value.items) given.places.push_back(item.where);
  return given;
}

// Its text as a table; nullopt where there is none.
Result<std::optional<SceneDesc>> read_config() {
  namespace fs = std::filesystem;
  const fs::path file = kProjectConfig;
  std::error_code missing;
  const Format* toml = find_format("toml");
  if (toml == nullptr || fs::symlink_status(file, missing).type() == fs::file_type::not_found)
    return std::nullopt;
  // A pipe could keep the reader for ever, and messages quote what is read.
  if (!fs::is_regular_file(file, missing) || !path_beneath(folder_of(file), file))
    return fail(named_place(file.string()), "is not a plain file of this folder",
                "remove it, or write options there", Trouble::missing);
  FLATRAY_TRY(text, read_file(file, {kMostConfigBytes}));
  if (text->starts_with(kByteOrderMark)) text->erase(0, kByteOrderMark.size());
  return toml->read(std::make_shared<const SourceText>(file.string(), std::move(*text)), {});
}

}  // namespace

void add_project_config(std::span<const Option> options, Arguments& arguments) {
  const auto parsed = read_config();
  if (parsed && !*parsed) return;
  Diagnostics problems = parsed ? Diagnostics{} : parsed.error();
  const std::vector<std::string> known = all_options();
  for (const Member& member : parsed ? (*parsed)->root.members : std::vector<Member>{}) {
    const auto option = std::ranges::find(options, member.key, &Option::name);
    if (!std::ranges::binary_search(known, member.key)) {
      problems.push_back(unknown_word(member.where, "option", member.key, known));
    } else if (option != options.end()) {
      const auto values = values_of(*option, member.value);
      if (!values)
        problems.push_back(values.error().front());
      else if (*values && !arguments.denied.contains(member.key) &&
               (!arguments.has(member.key) || option->has_keys()))
        arguments.add_farther(member.key, given_by(member.value, **values));
    }
  }
  for (Diagnostic& problem : problems) {
    if (problem.trouble != Trouble::missing) problem.trouble = Trouble::usage;
    arguments.problems.push_back(std::move(problem));
  }
}

}  // namespace flatray
