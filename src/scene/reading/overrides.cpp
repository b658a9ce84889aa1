#include "scene/reading/overrides.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "base/counted.h"
#include "base/number_text.h"
#include "scene/reading/format.h"
#include "scene/reading/vocabulary.h"

namespace flatray {
namespace {

// The value at the end of a dotted key is what was written after "="; the tables before it stand at
// their keys.
bool is_part_of_key(const Value& value) {
  return value.kind == Value::Kind::table && !source_text(value).starts_with('{');
}

std::vector<std::string> names_of(const Value& array) {
  std::vector<std::string> names;
  for (const Value& item : array.items)
    if (const Member* name = item.find("name")) names.push_back(name->value.text);
  return names;
}

// Entry of an array by number or name.
Result<Value*> entry(Value& array, const Member& step) {
  if (const auto index = parse_digits<std::size_t>(step.key)) {
    if (*index < array.items.size()) return &array.items[*index];
    return fail(step.where, fmt::format("there is no entry {}", *index),
                fmt::format("the scene has {}, numbered from 0",
                            counted(array.items.size(), "entry", "entries")),
                Trouble::usage);
  }
  Value* found = nullptr;
  for (Value& item : array.items)
    if (const Member* name = item.find("name"); name != nullptr && name->value.text == step.key) {
      if (found != nullptr)
        return fail(step.where, fmt::format("two entries are named '{}'", step.key),
                    "say which by its number, from 0", Trouble::usage);
      found = &item;
    }
  if (found != nullptr) return found;
  Diagnostic unknown = unknown_word(step.where, "name", step.key, names_of(array));
  unknown.trouble = Trouble::usage;
  return tl::unexpected(Diagnostics{std::move(unknown)});
}

// Part of a table or array that a step names; a table's is made where it is missing.
Result<Value*> part(Value& whole, const Member& step) {
  if (whole.kind == Value::Kind::array) return entry(whole, step);
  if (whole.kind != Value::Kind::table)
    return fail(step.where, fmt::format("'{}' stands in {}", step.key, kind_name(whole.kind)),
                "only tables and arrays have parts", Trouble::usage);
  if (Member* member = whole.find(step.key)) return &member->value;
  whole.members.push_back({step.key, step.where, table_value(step.where, {})});
  return &whole.members.back().value;
}

// Follows the one chain of keys in `step` down the scene and puts its value there.
Result<void> put(SceneDesc& desc, const Member* step) {
  Value* target = &desc.root;
  for (;;) {
    FLATRAY_TRY(next, part(*target, *step));
    target = *next;
    if (!is_part_of_key(step->value)) break;
    step = &step->value.members.front();
  }
  const Place replaced = std::exchange(*target, step->value).where;
  const bool is_new = replaced.source == step->where.source;  // its table was made for it
  desc.options.push_back(
      {step->where.source, step->value.where.offset, is_new ? Place{} : replaced});
  return {};
}

bool is_one_key(const Value& table) {
  return table.members.size() == 1 &&
         (!is_part_of_key(table.members.front().value) || is_one_key(table.members.front().value));
}

// Whether a value that TOML cannot read is a word left without its quotes, or a colour.
bool is_bare(const std::string& value) {
  const auto in_word = [](char c) {
    return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') || c == '_' ||
           c == '-' || c == '.' || c == '/' || c == '#';
  };
  const char first = value.empty() ? '0' : value.front();
  return !('0' <= first && first <= '9') && first != '-' && first != '.' &&
         std::ranges::all_of(value, in_word);
}

bool is_in_file(const Place& place) { return place && !place.source->text().empty(); }

std::string name_of(const Override& one) {
  return fmt::format("{} {}", one.where ? one.where.source->name() : "-D", one.key);
}

Result<SceneDesc> read_override(const Format& toml, const Override& one, const std::string& value) {
  return toml.read(std::make_shared<const SourceText>(
                       name_of(one), fmt::format("{} = {}", one.key, value),
                       is_in_file(one.where) ? std::make_shared<const Place>(one.where) : nullptr,
                       SourceText::Kind::option),
                   {});
}

}  // namespace

Result<void> apply_override(SceneDesc& desc, const Override& override_value) {
  const std::string& value = override_value.value;
  const Place where = is_in_file(override_value.where) ? override_value.where
                                                       : named_place(name_of(override_value));
  const Format* toml = find_format("toml");
  if (toml == nullptr)
    return fail(where, "-D needs TOML, which this build leaves out", "", Trouble::unavailable);
  Result<SceneDesc> parsed = read_override(*toml, override_value, value);
  if (!parsed && is_bare(value))
    if (auto quoted = read_override(*toml, override_value, fmt::format("\"{}\"", value)))
      parsed = std::move(quoted);
  if (parsed && !is_one_key(parsed->root))
    parsed = fail(where, "this is not one key and one value", "write -D film.size=[640,360]",
                  Trouble::usage);
  if (!parsed) return fail(std::move(parsed));
  return put(desc, &parsed->root.members.front());
}

bool is_override(const Place& place) {
  return place && place.source->kind() == SourceText::Kind::option;
}

void tell_where_said(Diagnostics& problems) {
  for (Diagnostic& problem : problems) {
    if (!is_override(problem.where)) continue;
    problem.trouble = Trouble::usage;
    if (const Place* said = problem.where.source->named_at()) problem.where = Place(*said);
  }
}

Place place_of_change(const Value& value, const Place& otherwise) {
  if (is_override(value.where)) return value.where;
  for (const Value& item : value.items)
    if (Place place = place_of_change(item, {})) return place;
  for (const Member& member : value.members)
    if (Place place = place_of_change(member.value, {})) return place;
  return otherwise;
}

}  // namespace flatray
