#include "app/help/help.h"

#include <fmt/core.h>

#include <algorithm>

#include "app/options/option_values.h"
#include "base/table.h"
#include "scene/reading/vocabulary.h"

namespace flatray {
namespace {

Table key_table(std::span<const KeyInfo> keys) {
  Table table({"key", "takes", "default"});
  for (const KeyInfo& key : keys) table.add({key.name, key.takes, key.fallback});
  return table;
}

// "shape" of the arguments of a box; "" for a table of the language.
std::string kind_of(const TableInfo& table) {
  for (const KindInfo& kind : kinds())
    for (const TableInfo& one : kind.tables)
      if (one.table == table.table) return kind.key;
  return "";
}

std::string title_of(const TableInfo& table) {
  const std::string kind = kind_of(table);
  if (!kind.empty()) return fmt::format("{} = {{ {} = {{ ... }} }}", kind, KindInfo::name(table));
  return table.table == "scene" ? "scene: the keys of the file itself" : table.table;
}

std::string table_text(const TableInfo& table) {
  const std::string keys = table.keys.empty()
                               ? fmt::format("  has no keys; as in: {} = {{ {} = {{}} }}\n",
                                             kind_of(table), KindInfo::name(table))
                               : aligned_text(key_table(table.keys), {"  "});
  return title_of(table) + "\n" + keys;
}

std::vector<TableInfo> tables_named(std::string_view names) {
  const std::vector<std::string_view> wanted = split(names, ' ');
  std::vector<TableInfo> found = vocabulary();
  std::erase_if(found, [&](const TableInfo& table) {
    return std::ranges::find(wanted, table.table) == wanted.end();
  });
  return found;
}

// What is called so alone: "glass" is "material.glass".
std::vector<TableInfo> kinds_named(std::string_view name) {
  std::vector<TableInfo> found = vocabulary();
  std::erase_if(found, [&](const TableInfo& table) { return KindInfo::name(table) != name; });
  return found;
}

std::string topic_text(const WrittenTopic& topic) {
  std::string text = fmt::format("{}: {}\n\n{}", topic.name, topic.summary, topic.text);
  for (const TableInfo& table : tables_named(topic.tables)) text += "\n" + table_text(table);
  return text;
}

void add_name(std::vector<std::string>& names, std::string name) {
  if (std::ranges::find(names, name) == names.end()) names.push_back(std::move(name));
}

}  // namespace

std::vector<std::string> help_names() {
  std::vector<std::string> names;
  for (const Verb* verb : all_verbs()) add_name(names, verb->name);
  for (const WrittenTopic& topic : written_topics()) add_name(names, topic.name);
  for (const TableInfo& table : vocabulary()) add_name(names, table.table);
  return names;
}

std::string help_text() {
  std::string text =
      "flatray renders 2D scenes to pictures, exactly.\n\n"
      "  flatray VERB SCENE... [options]\n\n";
  for (const Verb* verb : all_verbs())
    text += fmt::format("  {:<11} {}\n", verb->name, verb->summary);
  text += "\nflatray help VERB shows its options; flatray help TOPIC, where the topics are\n";
  for (const WrittenTopic& topic : written_topics())
    text += fmt::format("  {:<11} {}\n", topic.name, topic.summary);
  return text +
         "and every table, shape, material and lamp of scenes, as in: flatray help film\n\n"
         "flatray --version says what is built in. An option --size can also be set by "
         "FLATRAY_SIZE,\n"
         "or for a folder by size = \"640x360\" in its flatray.toml.\n"
         "Exit codes: 0 done, 1 the answer is no, 2 usage, 3 input missing, 4 input invalid,\n"
         "5 not in this build, 6 output not written, 70 internal, 124 over a limit of time or "
         "memory,\n"
         "129 hung up, 130 interrupted, 143 terminated.\n";
}

std::string help_text(const Verb& verb) {
  std::string text = fmt::format("flatray {}{}{} [options]\n\n{}.\n\n", verb.name,
                                 *verb.operands == '\0' ? "" : " ", verb.operands, verb.summary);
  for (const Option& option : options_of(verb)) {
    const std::string letter =
        option.letter == '\0' ? std::string("    ") : fmt::format("-{}, ", option.letter);
    const std::string name = fmt::format("--{} {}", option.name, option.metavar);
    text += fmt::format("  {}{:<24} {}\n", letter, name, option.help);
  }
  if (*verb.examples != '\0') text += fmt::format("\nExamples\n{}", verb.examples);
  return text;
}

Result<std::string> help_page(const std::string& name) {
  if (const Verb* verb = find_verb(name)) return help_text(*verb);
  for (const WrittenTopic& topic : written_topics())
    if (name == topic.name) return topic_text(topic);
  if (const std::vector<TableInfo> tables = tables_named(name); !tables.empty())
    return table_text(tables.front());
  std::string text;
  for (const TableInfo& table : kinds_named(name))
    text += (text.empty() ? "" : "\n") + table_text(table);
  if (!text.empty()) return text;
  return unknown_name(named_place("help"), "topic", name, help_names());
}

}  // namespace flatray
