#include "scene/reading/vocabulary.h"

#include <fmt/core.h>

#include "base/left_out.h"
#include "scene/keys/build_scene.h"
#include "scene/lamp.h"
#include "scene/material.h"
#include "scene/shape.h"

namespace flatray {
namespace {

// More than this of one table are not slips of the pen.
constexpr std::size_t kMaxUnknownKeys = 20;

// Words of other programs for what is a key here.
constexpr std::pair<std::string_view, std::string_view> kOtherWords[] = {
    {"bg", "background"},   {"border", "stroke"},   {"color", "fill"},     {"color", "colour"},
    {"colour", "fill"},     {"outline", "stroke"},  {"pos", "at"},         {"position", "at"},
    {"resolution", "size"}, {"rotate", "angle"},    {"rotation", "angle"}, {"speed", "velocity"},
    {"thickness", "width"}, {"vertices", "points"}, {"z", "layer"},        {"zoom", "height"},
};

// Words for a message, which there may be thousands of.
std::string some(const std::vector<std::string>& words) {
  constexpr std::size_t kMostWords = 40, kMostBytes = 64;
  std::string all;
  for (const std::string& word : std::span(words).first(std::min(words.size(), kMostWords)))
    all += (all.empty() ? "" : ", ") + word.substr(0, kMostBytes);
  return words.size() > kMostWords ? all + ", ..." : all;
}

// The key that was meant by another, or "".
std::string meant(const std::string& key, const std::vector<std::string>& known) {
  for (const auto& [other, here] : kOtherWords)
    if (key == other && std::ranges::find(known, here) != known.end()) return std::string(here);
  return nearest_word(key, known);
}

}  // namespace

Diagnostic unknown_word(Place where, std::string_view what, std::string_view word,
                        const std::vector<std::string>& known) {
  if (const auto problem = if_left_out(where, what, word)) return *problem;
  const std::string near = nearest_word(word, known);
  const std::string message = fmt::format("unknown {} '{}'", what, word.substr(0, 64));
  if (near.empty())
    return {std::move(where), message,
            known.empty() ? fmt::format("there is no {} yet: write one, or leave this out", what)
                          : "known: " + some(known)};
  return {std::move(where), fmt::format("{} (did you mean '{}'?)", message, near), {}};
}

void check_keys(const Value& table, std::string_view table_name, std::span<const KeyInfo> keys,
                Diagnostics& problems) {
  const std::vector<std::string> known = names_of(keys);
  std::size_t unknown = 0;
  for (const Member& member : table.members) {
    if (std::ranges::find(known, member.key) != known.end()) continue;
    if (++unknown > kMaxUnknownKeys) break;
    const std::string near = meant(member.key, known);
    std::string message =
        fmt::format("unknown key '{}' of {}", member.key.substr(0, 64), table_name);
    if (!near.empty()) message += fmt::format(" (did you mean '{}'?)", near);
    problems.push_back({member.where, message,
                        !near.empty()   ? ""
                        : known.empty() ? "it has no keys: write {}"
                                        : "known: " + comma_list(known)});
  }
  for (const KeyInfo& key : keys)
    if (key.fallback == kRequired && table.find(key.name) == nullptr)
      problems.push_back({table.where, fmt::format("{} needs '{}'", table_name, key.name),
                          fmt::format("write {} = {}", key.name, key.takes)});
}

namespace {

template <class Type>
std::vector<TableInfo> tables_of(const std::vector<const Type*>& types, const std::string& before,
                                 bool drawn) {
  std::vector<TableInfo> tables;
  tables.reserve(types.size());
  for (const Type* type : types)
    tables.push_back({before + type->name, {type->keys.begin(), type->keys.end()}, drawn});
  return tables;
}

}  // namespace

std::vector<KindInfo> kinds() {
  return {{"KIND", "shape", tables_of(shape_types(), "", true)},
          {"LAMP", "source", tables_of(lamp_types(), "lamp.", true)},
          {"MATERIAL", "material", tables_of(material_types(), "material.", true)}};
}

std::vector<TableInfo> vocabulary() {
  std::vector<TableInfo> all = language_tables();
  for (KindInfo& kind : kinds())
    std::move(kind.tables.begin(), kind.tables.end(), std::back_inserter(all));
  return all;
}

}  // namespace flatray
