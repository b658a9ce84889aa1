#include "app/schema.h"

#include <fmt/core.h>

#include <algorithm>

#include "base/check.h"
#include "scene/build_scene.h"
#include "scene/shape.h"
#include "scene/takes.h"

namespace flatray {
namespace {

constexpr const char* kColour = "^#([0-9a-fA-F]{6}|[0-9a-fA-F]{8})$";
// Names in upper case that are not the user's to choose freely.
constexpr const char* kStateName = "^[A-Z][A-Z0-9_]*$";

JsonValue of_type(const char* type) { return Fields{{"type", type}}; }
JsonValue reference(const std::string& definition) {
  return Fields{{"$ref", "#/definitions/" + definition}};
}

// The key of a table while its schema is made.
struct Site {
  const std::vector<TableInfo>& tables;
  const std::string& table;
  const char* key;
};

bool has_keys(const TableInfo& table, const Takes& takes) {
  return std::all_of(takes.keys.begin(), takes.keys.end(), [&](const auto& wanted) {
    return std::any_of(table.keys.begin(), table.keys.end(),
                       [&](const KeyInfo& key) { return wanted.first == key.name; });
  });
}

// The table called as the key, below its own or by itself; else the first that has the keys shown.
std::string table_of(const Site& site, const Takes& takes) {
  for (const std::string& name : {site.table + "." + site.key, std::string(site.key)})
    for (const TableInfo& table : site.tables)
      if (table.table == name) return name;
  for (const TableInfo& table : site.tables)
    if (!takes.keys.empty() && has_keys(table, takes)) return table.table;
  FLATRAY_CHECK(false, fmt::format("{}.{} takes a table that is none", site.table, site.key));
  unreachable();
}

JsonValue any_of(const Site& site, const std::vector<Takes>& all);

// { KIND = ... } is a shape, { STATE = ... } holds what the user names.
JsonValue table_schema(const Site& site, const Takes& takes) {
  if (takes.keys.empty() || !is_placeholder(takes.keys.front().first))
    return reference(table_of(site, takes));
  if (takes.keys.front().first == "KIND") return reference("KIND");
  return Fields{{"type", "object"},
                {"propertyNames", Fields{{"pattern", kStateName}}},
                {"additionalProperties", any_of(site, takes.keys.front().second)}};
}

// What may stand instead of a value: a distribution, of numbers and points also a curve. Where they
// may not, the program says so.
JsonValue or_drawn(JsonValue value, bool or_curve) {
  Values all{std::move(value), reference("DRAWN")};
  if (or_curve) all.push_back(reference("curve"));
  return Fields{{"anyOf", std::move(all)}};
}

JsonValue drawn_schema() {
  const Fields pair{{"type", "array"},
                    {"items", of_type("number")},
                    {"minItems", std::uint64_t{2}},
                    {"maxItems", std::uint64_t{2}}};
  return Fields{
      {"type", "object"},
      {"properties", Fields{{"uniform", pair}, {"normal", pair}, {"choice", of_type("array")}}},
      {"additionalProperties", false},
      {"minProperties", std::uint64_t{1}},
      {"maxProperties", std::uint64_t{1}}};
}

bool is_point(const Takes& takes) {
  return !takes.more && takes.items.size() == 2 &&
         std::all_of(takes.items.begin(), takes.items.end(), [](const std::vector<Takes>& item) {
           return item.size() == 1 && item.front().kind == Takes::Kind::number;
         });
}

JsonValue list_schema(const Site& site, const Takes& takes) {
  Values items;
  for (const std::vector<Takes>& item : takes.items) items.push_back(any_of(site, item));
  const auto count = static_cast<std::uint64_t>(items.size());
  if (takes.more) return Fields{{"type", "array"}, {"items", items.back()}};
  const Fields list{{"type", "array"}, {"items", items}, {"minItems", count}, {"maxItems", count}};
  return is_point(takes) ? or_drawn(list, true) : JsonValue(list);
}

JsonValue one_schema(const Site& site, const Takes& takes) {
  switch (takes.kind) {
    case Takes::Kind::number:
      return reference("NUMBER");
    case Takes::Kind::whole:  // 5.0 and 1e3 are whole, too, which editors count as such
      return of_type("integer");
    case Takes::Kind::truth:
      return of_type("boolean");
    case Takes::Kind::literal:
      return Fields{{"const", *parse_json(takes.text)}};
    case Takes::Kind::word:
      return Fields{{"const", takes.text}};
    case Takes::Kind::text:
      return of_type("string");
    case Takes::Kind::colour:
      return or_drawn(Fields{{"type", "string"}, {"pattern", kColour}}, false);
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

JsonValue any_of(const Site& site, const std::vector<Takes>& all) {
  if (all.empty()) return Fields{};
  if (all.size() == 1) return one_schema(site, all.front());
  Values values;
  const bool words = std::all_of(all.begin(), all.end(),
                                 [](const Takes& one) { return one.kind == Takes::Kind::word; });
  for (const Takes& one : all)
    values.push_back(words ? JsonValue(one.text) : one_schema(site, one));
  return Fields{{words ? "enum" : "anyOf", std::move(values)}};
}

JsonValue key_schema(const Site& site, const KeyInfo& key) {
  const auto takes = parse_takes(key.takes);
  FLATRAY_CHECK(takes.has_value(), fmt::format("{}.{}: {}", site.table, key.name, key.takes));
  JsonValue schema = any_of(site, *takes);
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
                    std::span<const KeyInfo> keys) {
  Fields properties, patterns;
  Values required;
  for (const KeyInfo& key : keys) {
    const Site site{tables, name, key.name};
    if (is_placeholder(key.name)) {
      patterns.emplace_back(kStateName, key_schema(site, key));
      continue;
    }
    properties.emplace_back(key.name, key_schema(site, key));
    if (key.fallback == kRequired) required.emplace_back(key.name);
  }
  Fields fields{{"type", "object"}, {"properties", std::move(properties)}};
  if (!patterns.empty()) fields.emplace_back("patternProperties", std::move(patterns));
  if (!required.empty()) fields.emplace_back("required", std::move(required));
  fields.emplace_back("additionalProperties", false);
  return fields;
}

// Exactly one kind of shape.
JsonValue shape_schema() {
  Fields kinds;
  for (const ShapeType* shape : shape_types())
    kinds.emplace_back(shape->name, reference(std::string("shape.") + shape->name));
  kinds.emplace_back("choice", Fields{{"type", "array"}, {"items", reference("KIND")}});
  return Fields{{"type", "object"},
                {"properties", std::move(kinds)},
                {"additionalProperties", false},
                {"minProperties", 1},
                {"maxProperties", 1}};
}

}  // namespace

JsonValue scene_schema() {
  const std::vector<TableInfo> tables = language_tables();
  Fields definitions;
  for (const TableInfo& table : tables)
    definitions.emplace_back(table.table, table_fields(tables, table.table, table.keys));
  definitions.emplace_back("KIND", shape_schema());
  definitions.emplace_back("NUMBER", or_drawn(of_type("number"), true));
  definitions.emplace_back("DRAWN", drawn_schema());
  for (const ShapeType* shape : shape_types())
    definitions.emplace_back(std::string("shape.") + shape->name,
                             table_fields(tables, shape->name, shape->keys));
  Fields schema{{"$schema", "http://json-schema.org/draft-07/schema#"},
                {"title", "flatray scene"},
                {"description", "flatray = 1: docs/SCENE_FORMAT.md"}};
  Fields scene = std::get<Fields>(definitions.front().second.data);
  std::move(scene.begin(), scene.end(), std::back_inserter(schema));
  schema.emplace_back("definitions", std::move(definitions));
  return schema;
}

}  // namespace flatray
