#include "app/options/project_config.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "app/help/help.h"
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

class Config {
 public:
  Config(std::span<const Option> options, std::filesystem::path folder)
      : options_(options), folder_(std::move(folder)) {}

  Diagnostics problems;

  // What a key gives; nullopt where it is wrong, a flag not set, or for another verb.
  std::optional<std::vector<std::string>> values(const Member& member) {
    if (std::find(known_.begin(), known_.end(), member.key) == known_.end()) {
      problems.push_back(unknown_word(member.where, "option", member.key, known_));
      return std::nullopt;
    }
    const auto option = std::find_if(options_.begin(), options_.end(),
                                     [&](const Option& one) { return member.key == one.name; });
    if (option == options_.end()) return std::nullopt;
    if (option->kind == OptionKind::flag) return flag(member);
    if (option->kind == OptionKind::list && member.value.kind == Value::Kind::array)
      return list(member);
    const std::optional<std::string> text = text_of(member.value);
    if (text && names_path(option->metavar) && !path_beneath(folder_, *text))
      return refuse_place(member, *text);
    if (text) return std::vector{*text};
    return refuse(member, "a number or string");
  }

 private:
  using Values = std::optional<std::vector<std::string>>;

  Values flag(const Member& member) {
    if (member.value.kind != Value::Kind::boolean) return refuse(member, "true or false");
    return member.value.text == "true" ? Values(std::in_place) : std::nullopt;
  }
  Values list(const Member& member) {
    std::vector<std::string> all;
    for (const Value& item : member.value.items) {
      const std::optional<std::string> text = text_of(item);
      if (!text) return refuse(member, "a list of strings");
      all.push_back(*text);
    }
    return all;
  }
  // Whoever wrote the folder is not the one who runs a program in it.
  std::nullopt_t refuse_place(const Member& member, const std::string& path) {
    problems.push_back({member.value.where,
                        fmt::format("{} is '{}', outside of this folder", member.key, path),
                        fmt::format("say --{} {} on the command line", member.key, path)});
    return std::nullopt;
  }
  std::nullopt_t refuse(const Member& member, const char* expected) {
    problems.push_back(
        {member.value.where,
         fmt::format("{} is {}, not {}", member.key, kind_name(member.value.kind), expected),
         "write it as on the command line, without the dashes"});
    return std::nullopt;
  }

  std::span<const Option> options_;
  std::filesystem::path folder_;
  const std::vector<std::string> known_ = all_options();
};

// As on the command line: the options are wrong, not the scene.
tl::unexpected<Diagnostics> refused(Diagnostics problems) {
  for (Diagnostic& problem : problems) problem.trouble = Trouble::usage;
  return tl::unexpected(std::move(problems));
}

}  // namespace

Result<Arguments> with_project_config(std::span<const Option> options, Arguments arguments,
                                      const std::filesystem::path& file) {
  namespace fs = std::filesystem;
  std::error_code missing;
  const Format* toml = find_format("toml");
  if (toml == nullptr || fs::symlink_status(file, missing).type() == fs::file_type::not_found)
    return arguments;
  // A pipe could keep the reader for ever, and messages quote what is read.
  if (!fs::is_regular_file(file, missing) || !path_beneath(folder_of(file), file))
    return fail(named_place(file.string()), "is not a plain file of this folder",
                "remove it, or write options there", Trouble::missing);
  Result<std::string> text = read_file(file, {kMostConfigBytes});
  if (!text) return fail(std::move(text));
  if (text->starts_with(kByteOrderMark)) text->erase(0, kByteOrderMark.size());
  Result<SceneDesc> parsed =
      toml->read(std::make_shared<const SourceText>(file.string(), std::move(*text)), {});
  if (!parsed) return refused(std::move(parsed).error());
  Config config(options, folder_of(file));
  auto given = arguments.given();
  for (const Member& member : parsed->root.members)
    if (auto values = config.values(member); values && !arguments.has(member.key))
      given[member.key] = {file.string(), std::move(*values), member.value.where};
  if (!config.problems.empty()) return refused(std::move(config.problems));
  return Arguments(std::move(given), arguments.operands());
}

}  // namespace flatray
