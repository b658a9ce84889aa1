#include "app/help/completion.h"

#include <fmt/core.h>

#include <algorithm>

#include "app/files/output_pattern.h"
#include "app/options/option_values.h"
#include "app/options/places.h"
#include "base/shown_text.h"
#include "scene/keys/build_scene.h"
#include "scene/load.h"
#include "scene/reading/format.h"

namespace flatray {
namespace {

namespace fs = std::filesystem;

// Words of a command line as the options of its verb divide them.
struct CommandLine {
  std::vector<Option> options;
  std::vector<std::string> operands;  // before the last word
  const Option* open = nullptr;       // whose value the last word is
  std::string last, before_value;     // "--size=" of "--size=3", whose last is "3"
};

const Option* find_option(const CommandLine& line, const std::string& word) {
  for (const Option& option : line.options)
    if (word == fmt::format("--{}", option.name) ||
        (option.letter != '\0' && word == fmt::format("-{}", option.letter)))
      return &option;
  return nullptr;
}

CommandLine divide(const Verb& verb, std::vector<std::string> words) {
  CommandLine line{options_of(verb), {}, nullptr, words.back(), {}};
  words.pop_back();
  for (const std::string& word : words) {
    if (word == "=") continue;  // bash parts --size=3 into three words
    const Option* option = line.open == nullptr ? find_option(line, word) : nullptr;
    if (line.open == nullptr && option == nullptr && !word.starts_with("-"))
      line.operands.push_back(word);
    line.open = option != nullptr && option->kind != OptionKind::flag ? option : nullptr;
  }
  if (line.last == "=" && line.open != nullptr) line.last.clear();
  const std::size_t equals = line.last.find('=');
  if (line.open != nullptr || !line.last.starts_with("--") || equals == std::string::npos)
    return line;
  line.open = find_option(line, line.last.substr(0, equals));
  line.before_value = line.last.substr(0, equals + 1);
  line.last.erase(0, equals + 1);
  return line;
}

// Names that stand in the first scene of the command line.
template <class Names>
std::vector<std::string> names_in_scene(const CommandLine& line, const Names& names) {
  std::vector<std::string> found;
  for (const std::string& operand : line.operands) {
    std::error_code missing;  // a pipe or device could keep the shell for ever
    if (format_for_name(operand) == nullptr || !fs::is_regular_file(operand, missing)) continue;
    const Result<LoadedScene> loaded = load_scene(operand);
    if (!loaded) continue;
    for (const auto& one : names(loaded->scene))
      if (!one.name.empty()) found.push_back(one.name);
    break;
  }
  return found;
}

std::vector<std::string> keys_to_set() {
  std::vector<std::string> keys;
  for (const TableInfo& table : language_tables())
    for (const KeyInfo& key : table.keys) {
      if (table.table == "scene") keys.push_back(fmt::format("{}=", key.name));
      if (table.table == "film" || table.table == "camera")
        keys.push_back(fmt::format("{}.{}=", table.table, key.name));
    }
  return keys;
}

bool is_ending(const std::string& word) { return word.starts_with("."); }

// What stands for others, as V and N.
bool is_upper(std::string_view word) {
  return std::ranges::all_of(word, [](char c) { return c >= 'A' && c <= 'Z'; });
}

void add(Completion& completion, const CommandLine& line, const std::vector<std::string>& words) {
  for (const std::string& word : words)
    if (word.starts_with(line.last) && shown_text(word) == word)  // else no line holds it
      completion.candidates.push_back({line.before_value + word, ""});
}

// The words of an option or a verb, with the endings of the files it takes among them.
void add_listed(Completion& completion, const CommandLine& line, std::vector<std::string> words) {
  for (const std::string& word : words)
    if (is_ending(word)) completion.extensions.push_back(word.substr(1));
  std::erase_if(words, &is_ending);
  add(completion, line, words);
}

void add_scene_files(Completion& completion) {
  for (const Format* format : formats())
    for (const std::string_view extension : format->extensions)
      completion.extensions.emplace_back(extension);
}

// What a name in upper case stands for, or the words themselves: "png|hdr".
void add_values(Completion& completion, const CommandLine& line, const std::string& what,
                std::vector<std::string> (*words)()) {
  if (words != nullptr) return add_listed(completion, line, words());
  if (what == "FILE|-") {
    completion.extensions = {"jsonl", "json"};
    return;
  }
  if (auto parts = split(what, '|'); parts.size() > 1) {
    std::erase_if(parts, &is_upper);
    return add(completion, line, {parts.begin(), parts.end()});
  }
  if (what == "SCENE") return add_scene_files(completion);
  if (what == "ENTITY")
    return add(completion, line, names_in_scene(line, [](const Scene& s) { return s.entities; }));
  if (what == "RAY")
    return add(completion, line, names_in_scene(line, [](const Scene& s) { return s.rays; }));
  if (what.starts_with("KEY=")) return add(completion, line, keys_to_set());
  if (what == "FOLDER" || what == "DIR") completion.folders = true;
  if (what == "PATTERN") completion.extensions = picture_format_names();
  const std::size_t dot = what.find('.');
  if (dot != std::string::npos && is_upper(what.substr(0, dot)))
    completion.extensions = {what.substr(dot + 1)};
}

void complete_operand(Completion& completion, const CommandLine& line, const Verb& verb) {
  if (line.last.starts_with("-")) {
    for (const Option& option : line.options) {
      const std::string word = fmt::format("--{}", option.name);
      if (word.starts_with(line.last)) completion.candidates.push_back({word, option.help});
    }
    return;
  }
  if (line.operands.size() >= verb.most_operands()) return;
  const bool named =
      verb.words != nullptr && (line.operands.empty() || is_ending(verb.words().front()));
  add_values(completion, line, operand_word(verb, line.operands.size()),
             named ? verb.words : nullptr);
}

}  // namespace

Completion complete(const std::vector<std::string>& words) {
  Completion completion;
  if (words.size() < 2) return completion;
  if (words.size() == 2) {
    for (const Verb* verb : all_verbs())
      if (std::string_view(verb->name).starts_with(words[1]))
        completion.candidates.push_back({verb->name, verb->summary});
    return completion;
  }
  const Verb* verb = find_verb(words[1]);
  if (verb == nullptr) return completion;
  CommandLine line = divide(*verb, {words.begin() + 2, words.end()});
  const bool lists = line.open != nullptr && line.open->metavar.find(',') != std::string::npos;
  if (const std::size_t comma = line.last.rfind(','); lists && comma != std::string::npos) {
    line.before_value += line.last.substr(0, comma + 1);
    line.last.erase(0, comma + 1);
  }
  if (line.open == nullptr)
    complete_operand(completion, line, *verb);
  else
    add_values(completion, line, line.open->metavar, line.open->words);
  return completion;
}

std::string completion_lines(const Completion& completion) {
  std::string text;
  for (const auto& [word, summary] : completion.candidates)
    text += summary.empty() ? word + "\n" : fmt::format("{}\t{}\n", word, summary);
  if (!completion.extensions.empty()) {
    text += "\tfiles";
    for (const std::string& extension : completion.extensions) text += " " + extension;
    text += "\n";
  }
  return text + (completion.folders ? "\tfolders\n" : "");
}

}  // namespace flatray
