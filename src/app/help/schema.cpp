#include "app/help/schema.h"

#include <fmt/core.h>

#include <algorithm>

#include "base/check.h"
#include "scene/keys/build_scene.h"
#include "scene/reading/takes.h"
#include "scene/reading/vocabulary.h"

namespace flatray {
namespace {

constexpr const char* kColour = "^#([0-9a-fA-F]{6}|[0-9a-fA-F]{8})$";
// Names in upper case that are not the user's to choose freely.
constexpr const char* kStateName = "^[A-Z][A-Z0-9_]*$";

JsonValue of_type(const char* type) { return Fields{{"type", type}}; }
JsonValue reference(const std::string& definition) {
  return Fields{{"$ref", "#/definitions/" + definition}};
}

// An object with no other properties.
Fields object_with(Fields properties, Values required = {}, Fields patterns = {}) {
  Fields fields{{"type", "object"}, {"properties", std::move(properties)}};
  if (!patterns.empty()) fields.emplace_back("patternProperties", std::move(patterns));
  if (!required.empty()) fields.emplace_back("required", std::move(required));
  fields.emplace_back("additionalProperties", false);
  return fields;
}

// An object with exactly one of some properties.
Fields one_of(Fields properties) {
  Fields fields = object_with(std::move(properties));
  fields.insert(fields.end(), {{"minProperties", 1}, {"maxProperties", 1}});
  return fields;
}

// The key of a table while its schema is made.
struct Site {
  const std::vector<TableInfo>& tables;
  const std::string& table;
  const char* key;
  bool drawn;          // whether values may be drawn at random
  bool curve = false;  // whether numbers may change with time
};

bool has_keys(const TableInfo& table, const Takes& takes) {
  return std::ranges::all_of(takes.keys, [&](const auto& wanted) {
    return std::ranges::find(table.keys, wanted.first, &KeyInfo::name) != table.keys.end();
  });
}

// The table called as the key, below its own or by itself.
std::optional<std::string> table_called(const Site& site) {
  for (const std::string& name : {site.table + "." + site.key, std::string(site.key)})
    for (const TableInfo& table : site.tables)
      if (table.table == name) return name;
  return std::nullopt;
}

// The first table that has the keys shown.
std::optional<std::string> table_with_keys(const Site& site, const Takes& takes) {
  for (const TableInfo& table : site.tables)
    if (!takes.keys.empty() && has_keys(table, takes)) return table.table;
  return std::nullopt;
}

JsonValue any_of(const Site& site, const std::vector<Takes>& all);

Site named_site(const Site& site, const std::string& name) {
  return {site.tables, site.table, name.c_str(), site.drawn, site.curve};
}

// { linear = { ... } }: just the keys shown. Nothing shown is anything, which a test finds.
JsonValue own_table_schema(const Site& site, const Takes& takes) {
  Fields properties;
  Values required;
  for (const auto& [key, values] : takes.keys) {
    properties.emplace_back(key, any_of(named_site(site, key), values));
    required.emplace_back(key);
  }
  if (properties.empty()) return properties;
  return object_with(std::move(properties), std::move(required));
}

bool is_kind(std::string_view placeholder) {
  const std::vector<KindInfo> all = kinds();
  return std::ranges::find(all, placeholder, &KindInfo::placeholder) != all.end();
}

// "shape.box": what a table of the language is called is not the name of a kind.
std::string definition_of(const KindInfo& kind, const TableInfo& one) {
  return std::string(kind.key) + "." + KindInfo::name(one);
}

// The kind called as the key: { segment = { from = [x, y], to = [x, y] } }.
std::optional<std::string> kind_called(const Site& site, const Takes& takes) {
  for (const KindInfo& kind : kinds())
    for (const TableInfo& one : kind.tables)
      if (KindInfo::name(one) == site.key && has_keys(one, takes)) return definition_of(kind, one);
  return std::nullopt;
}

// { KIND = ... } is one of registered kinds unless a table is called so, { STATE = ... } holds what
// the user names.
JsonValue table_schema(const Site& site, const Takes& takes) {
  const std::string first = takes.keys.empty() ? "" : takes.keys.front().first;
  if (is_placeholder(first) && !is_kind(first))
    return Fields{{"type", "object"},
                  {"propertyNames", Fields{{"pattern", kStateName}}},
                  {"additionalProperties", any_of(site, takes.keys.front().second)}};
  if (const auto name = table_called(takes.text.empty() ? site : named_site(site, takes.text)))
    return reference(*name);
  if (is_kind(first)) return reference(first);
  if (const auto name = kind_called(site, takes)) return reference(*name);
  if (const auto name = table_with_keys(site, takes)) return reference(*name);
  return own_table_schema(site, takes);
}

JsonValue list_schema(const Site& site, const Takes& takes) {
  Values items;
  for (const std::vector<Takes>& item : takes.items) items.push_back(any_of(site, item));
  const auto count = static_cast<std::uint64_t>(items.size());
  if (takes.more) return Fields{{"type", "array"}, {"items", items.back()}};
  return Fields{{"type", "array"}, {"items", items}, {"minItems", count}, {"maxItems", count}};
}

JsonValue one_schema(const Site& site, const Takes& takes) {
  switch (takes.kind) {
    case Takes::Kind::number:
    case Takes::Kind::whole:  // 5.0 and 1e3 are whole, too, which editors count as such
      return of_type(takes.kind == Takes::Kind::number ? "number" : "integer");
    case Takes::Kind::truth:
      return of_type("boolean");
    case Takes::Kind::literal:
      return Fields{{"const", *parse_json(takes.text)}};
    case Takes::Kind::word:
      return Fields{{"const", takes.text}};
    case Takes::Kind::text:
      return of_type("string");
    case Takes::Kind::colour:
      return Fields{{"type", "string"}, {"pattern", kColour}};
    case Takes::Kind::list:
      return list_schema(site, takes);
    case Takes::Kind::table:
      return table_schema(site, takes);
    case Takes::Kind::tables:
      return Fields{{"type", "array"}, {"items", reference(takes.text)}};
    case Takes::Kind::named:
      return Fields{{"type", "object"}, {"additionalProperties", reference(takes.text)}};
  }
  unreachable();
}

bool is_number(const Takes& takes) { return takes.kind == Takes::Kind::number; }

// What `{ choice = [...] }` may stand for: numbers, points, colours, shapes.
bool is_drawable(const Takes& takes) {
  if (takes.kind == Takes::Kind::table)
    return !takes.keys.empty() && takes.keys.front().first == "KIND";
  if (takes.kind == Takes::Kind::list)
    return !takes.more && takes.items.size() == 2 && is_number(takes.items[0].front());
  return is_number(takes) || takes.kind == Takes::Kind::colour;
}

// The alternatives and, instead of one, a random one.
JsonValue drawn_schema(const Site& site, const std::vector<Takes>& all) {
  Values values;
  for (const Takes& one : all) values.push_back(one_schema(site, one));
  if (std::ranges::any_of(all, is_number)) values.push_back(reference("drawn"));
  Fields choice{{"type", "array"}, {"items", Fields{{"anyOf", values}}}, {"minItems", 1}};
  values.push_back(object_with({{"choice", std::move(choice)}}, {"choice"}));
  return Fields{{"anyOf", std::move(values)}};
}

// One number drawn from a distribution, or from numbers, drawn ones too.
JsonValue distribution_schema() {
  const Fields pair{
      {"type", "array"}, {"items", of_type("number")}, {"minItems", 2}, {"maxItems", 2}};
  const Fields items{{"anyOf", Values{of_type("number"), reference("drawn")}}};
  const Fields choice{{"type", "array"}, {"items", items}, {"minItems", 1}};
  return one_of({{"uniform", pair}, {"normal", pair}, {"choice", choice}});
}

// Whether it is a curve, or a list of what may be.
bool is_curve(const Takes& takes) {
  return (takes.kind == Takes::Kind::table && takes.text == "curve") ||
         std::ranges::any_of(takes.items,
                             [](const auto& item) { return std::ranges::any_of(item, &is_curve); });
}

JsonValue any_of(const Site& site, const std::vector<Takes>& all) {
  if (all.empty()) return Fields{};
  if (site.curve && all.size() == 1 && is_number(all.front()))
    return any_of(site, {all.front(), Takes{Takes::Kind::table, "curve"}});
  if (site.drawn && std::ranges::any_of(all, is_drawable)) return drawn_schema(site, all);
  if (all.size() == 1) return one_schema(site, all.front());
  Values values;
  const bool words =
      std::ranges::all_of(all, [](const Takes& one) { return one.kind == Takes::Kind::word; });
  for (const Takes& one : all)
    values.push_back(words ? JsonValue(one.text) : one_schema(site, one));
  return Fields{{words ? "enum" : "anyOf", std::move(values)}};
}

JsonValue key_schema(const Site& site, const KeyInfo& key) {
  const auto takes = parse_takes(key.takes).value_or(std::vector<Takes>{});
  Site own = site;
  own.curve = std::ranges::any_of(takes, is_curve);
  JsonValue schema = any_of(own, takes);
  auto& fields = std::get<Fields>(schema.data);
  if (schema.find("$ref") != nullptr)  // which hides what stands beside it
    fields = {{"allOf", Values{schema}}};
  const bool required = key.fallback == kRequired;
  fields.emplace_back("description", required
                                         ? fmt::format("{}; required", key.takes)
                                         : fmt::format("{}; default: {}", key.takes, key.fallback));
  if (auto fallback = required ? std::nullopt : parse_json(key.fallback))
    fields.emplace_back("default", std::move(*fallback));
  return schema;
}

Fields table_fields(const std::vector<TableInfo>& tables, const std::string& name,
                    std::span<const KeyInfo> keys, bool drawn) {
  Fields properties, patterns;
  Values required;
  for (const KeyInfo& key : keys) {
    const Site site{tables, name, key.name, drawn};
    if (is_placeholder(key.name)) {
      patterns.emplace_back(kStateName, key_schema(site, key));
      continue;
    }
    properties.emplace_back(key.name, key_schema(site, key));
    if (key.fallback == kRequired) required.emplace_back(key.name);
  }
  return object_with(std::move(properties), std::move(required), std::move(patterns));
}

// Exactly one kind.
JsonValue kind_schema(const KindInfo& kind) {
  Fields all;
  for (const TableInfo& one : kind.tables)
    all.emplace_back(KindInfo::name(one), reference(definition_of(kind, one)));
  return one_of(std::move(all));
}

}  // namespace

JsonValue scene_schema() {
  const std::vector<TableInfo> tables = language_tables();
  Fields definitions;
  for (const TableInfo& table : tables)
    definitions.emplace_back(table.table,
                             table_fields(tables, table.table, table.keys, table.drawn));
  for (const KindInfo& kind : kinds())
    definitions.emplace_back(kind.placeholder, kind_schema(kind));
  definitions.emplace_back("drawn", distribution_schema());
  for (const KindInfo& kind : kinds())
    for (const TableInfo& one : kind.tables)
      definitions.emplace_back(definition_of(kind, one),
                               table_fields(tables, one.table, one.keys, one.drawn));
  Fields schema{{"$schema", "http://json-schema.org/draft-07/schema#"},
                {"title", "flatray scene"},
                {"description", "flatray = 1: docs/SCENE_FORMAT.md"}};
  Fields scene = std::get<Fields>(definitions.front().second.data);
  std::move(scene.begin(), scene.end(), std::back_inserter(schema));
  schema.emplace_back("definitions", std::move(definitions));
  return schema;
}

}  // namespace flatray
