// needs: formats/toml shapes/circle shapes/convex shapes/import shapes/polygon shapes/segment
#include "app/help/schema.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "base/file.h"
#include "scene/load.h"
#include "scene/reading/format.h"
#include "scene/reading/numbers.h"
#include "scene/reading/vocabulary.h"
#include "scene/table_texts.h"
#include "support/paths.h"

namespace flatray {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// A value of a scene as JSON: what an editor checks.
Json as_json(const Value& value) {
  switch (value.kind) {
    case Value::Kind::boolean:
      return value.text == "true";
    case Value::Kind::number: {
      if (const auto whole = parse_integer(source_text(value))) return *whole;
      const auto number = parse_literal(source_text(value));
      return number ? Json(number->value) : Json(std::string("not finite"));
    }
    case Value::Kind::array: {
      Json items = Json::array();
      for (const Value& item : value.items) items.push_back(as_json(item));
      return items;
    }
    case Value::Kind::table: {
      Json members = Json::object();
      for (const Member& member : value.members) members[member.key] = as_json(member.value);
      return members;
    }
    default:
      return value.text;
  }
}

// A validator of JSON Schema draft 7, as far as `flatray schema` uses it: a keyword it does not
// know is a fault.
class SchemaCheck {
 public:
  explicit SchemaCheck(Json schema) : root_(std::move(schema)) {}

  // "" for a valid value, else the first fault and where it is.
  std::string fault(const Json& value) const { return check(root_, value, ""); }

 private:
  std::string check(const Json& schema, const Json& value, const std::string& at) const {
    if (schema.is_boolean()) return schema.get<bool>() ? std::string() : at + ": is not wanted";
    for (const auto& [keyword, rule] : schema.items())
      if (std::string bad = keyword_fault(keyword, rule, schema, value, at); !bad.empty())
        return bad;
    return "";
  }

  std::string keyword_fault(const std::string& keyword, const Json& rule, const Json& schema,
                            const Json& value, const std::string& at) const {
    static const std::set<std::string> kNotes = {"$schema", "title", "description", "default",
                                                 "definitions"};
    if (kNotes.count(keyword) != 0) return "";
    const auto unless = [&](bool holds) { return holds ? "" : at + ": " + keyword; };
    if (keyword == "type") return unless(is_type(rule.get<std::string>(), value));
    if (keyword == "const") return unless(rule == value);
    if (keyword == "enum") return unless(std::find(rule.begin(), rule.end(), value) != rule.end());
    if (keyword == "pattern") return unless(!value.is_string() || matches(rule, value));
    if (keyword == "minItems") return unless(!value.is_array() || value.size() >= rule);
    if (keyword == "maxItems") return unless(!value.is_array() || value.size() <= rule);
    if (keyword == "minProperties") return unless(!value.is_object() || value.size() >= rule);
    if (keyword == "maxProperties") return unless(!value.is_object() || value.size() <= rule);
    if (keyword == "$ref")
      return check(root_.at(Json::json_pointer(rule.get<std::string>().substr(1))), value, at);
    if (keyword == "anyOf") return any_fault(rule, value, at);
    if (keyword == "allOf") {
      for (const Json& one : rule)
        if (std::string bad = check(one, value, at); !bad.empty()) return bad;
      return "";
    }
    if (keyword == "items") return items_fault(rule, value, at);
    return object_fault(keyword, rule, schema, value, at);
  }

  std::string object_fault(const std::string& keyword, const Json& rule, const Json& schema,
                           const Json& value, const std::string& at) const {
    static const std::set<std::string> kKnown = {"required", "propertyNames", "properties",
                                                 "patternProperties", "additionalProperties"};
    if (kKnown.count(keyword) == 0) return at + ": no such keyword: " + keyword;
    if (!value.is_object()) return "";
    if (keyword == "required")
      for (const Json& name : rule)
        if (!value.contains(name.get<std::string>())) return at + ": lacks " + name.dump();
    for (const auto& [name, item] : value.items()) {
      std::string bad;
      if (keyword == "propertyNames") bad = check(rule, Json(name), at + "/" + name);
      if (keyword == "properties" && rule.contains(name))
        bad = check(rule.at(name), item, at + "/" + name);
      if (keyword == "patternProperties")
        for (const auto& [pattern, inner] : rule.items())
          if (matches(pattern, name)) bad = check(inner, item, at + "/" + name);
      if (keyword == "additionalProperties" && !is_named(schema, name))
        bad = check(rule, item, at + "/" + name);
      if (!bad.empty()) return bad;
    }
    return "";
  }

  std::string any_fault(const Json& rule, const Json& value, const std::string& at) const {
    std::string all;
    for (const Json& one : rule) {
      const std::string bad = check(one, value, at);
      if (bad.empty()) return "";
      all += (all.empty() ? "" : "; ") + bad;
    }
    return all;
  }

  std::string items_fault(const Json& rule, const Json& value, const std::string& at) const {
    if (!value.is_array()) return "";
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (rule.is_array() && i >= rule.size()) break;
      const Json& one = rule.is_array() ? rule[i] : rule;
      if (std::string bad = check(one, value[i], at + "/" + std::to_string(i)); !bad.empty())
        return bad;
    }
    return "";
  }

  static bool is_type(const std::string& type, const Json& value) {
    if (type == "object") return value.is_object();
    if (type == "array") return value.is_array();
    if (type == "string") return value.is_string();
    if (type == "boolean") return value.is_boolean();
    if (type == "integer") return value.is_number_integer();
    return type == "number" && value.is_number();
  }
  static bool matches(const std::string& pattern, const std::string& text) {
    return std::regex_search(text, std::regex(pattern));
  }
  static bool is_named(const Json& schema, const std::string& name) {
    if (schema.contains("properties") && schema["properties"].contains(name)) return true;
    if (!schema.contains("patternProperties")) return false;
    for (const auto& [pattern, inner] : schema["patternProperties"].items())
      if (matches(pattern, name)) return true;
    return false;
  }

  Json root_;
};

SchemaCheck schema() { return SchemaCheck(Json::parse(json_text(scene_schema()))); }

// A scene as an editor sees it.
Json json_of(const std::string& text) {
  const auto source = std::make_shared<const SourceText>("t.toml", text);
  const Result<SceneDesc> desc = find_format("toml")->read(source, {});
  if (!desc) ADD_FAILURE() << format(desc.error());
  return desc ? as_json(desc->root) : Json();
}

std::vector<fs::path> scenes_below(const char* folder) {
  std::vector<fs::path> all;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(source_path()) / folder))
    if (entry.path().extension() == ".toml") all.push_back(entry.path());
  std::sort(all.begin(), all.end());
  return all;
}

TEST(SceneSchema, HoldsEverySceneOfTheProject) {
  const SchemaCheck check = schema();
  for (const fs::path& path : scenes_below("scenes"))
    EXPECT_EQ(check.fault(json_of(*read_file(path))), "") << path;
}

TEST(SceneSchema, RefusesTheRefusedScenesButForTheirSums) {
  const SchemaCheck check = schema();
  std::size_t told = 0;
  for (const fs::path& path : scenes_below("tests/scene/refused")) {
    const bool refused = !check.fault(json_of(*read_file(path))).empty();
    const bool has_unknown_key = path.stem().string().starts_with("unknown_");
    EXPECT_EQ(refused, has_unknown_key) << path;
    told += has_unknown_key;
  }
  EXPECT_GE(told, 3u);
}

// What fails here takes a table there is not: give it one, in the tables or by its keys.
TEST(SceneSchema, EveryKeyHasATypeAndEveryReferenceADefinition) {
  const Json root = Json::parse(json_text(scene_schema()));
  std::size_t keys = 0;
  for (const auto& [table, schema] : root["definitions"].items()) {
    if (!schema.contains("properties")) continue;
    for (const auto& [key, type] : schema["properties"].items()) {
      Json bare = type;
      bare.erase("default");
      bare.erase("description");  // says the default again
      EXPECT_EQ(bare.dump().find("{}"), std::string::npos) << table << "." << key;
      EXPECT_NE(type.begin().key(), "description") << table << "." << key;
      ++keys;
    }
  }
  EXPECT_GT(keys, 80u);
  const std::string all = root.dump();
  const std::string mark = "#/definitions/";
  for (std::size_t at = 0; (at = all.find(mark, at)) != std::string::npos; ++at) {
    const std::size_t begin = at + mark.size();
    const std::string name = all.substr(begin, all.find('"', begin) - begin);
    EXPECT_TRUE(root["definitions"].contains(name)) << name;
  }
}

TEST(SceneSchema, EveryTableRefusesAnUnknownKey) {
  const SchemaCheck check = schema();
  for (const TableText& table : kTables)
    EXPECT_NE(check.fault(json_of(with_key(table, "zq"))).find("/zq: is not wanted"),
              std::string::npos)
        << table.name;
}

// Two ways to read each key, the program's and the editor's, tried with values of every kind. What a
// curve holds, numbers, points or colours, the program alone tells.
TEST(SceneSchema, AgreesWithTheProgramAboutTheKindOfEveryKey) {
  const SchemaCheck check = schema();
  const char* const values[] = {"1",
                                "0.5",
                                "\"x\"",
                                "\"none\"",
                                "\"#ffffff\"",
                                "true",
                                "[1]",
                                "[1, 2]",
                                "[[1, 2], [3, 4]]",
                                "{}",
                                "[{}]",
                                "{ uniform = [1, 2] }",
                                "[{ uniform = [1, 2] }, { normal = [0, 1] }]",
                                "{ choice = [1, 2] }",
                                "[{ keys = [[0, 1]] }, 2]",
                                "{ choice = [\"#ffffff\", \"#000000\"] }"};
  std::size_t accepted = 0, refused = 0;
  for (const TableInfo& table : vocabulary())
    for (const KeyInfo& key : table.keys)
      for (const char* value : values) {
        const TableText* text = text_of(table.table);
        ASSERT_NE(text, nullptr) << table.table;
        const std::string scene = with_key(*text, key.name, value);
        const auto source = std::make_shared<const SourceText>("t.toml", scene);
        const Result<SceneDesc> desc = find_format("toml")->read(source, {});
        if (!desc) continue;  // the key stands there already
        const Result<LoadedScene> loaded = load_scene_text("t.toml", scene);
        const std::string fault = check.fault(as_json(desc->root));
        EXPECT_TRUE(!loaded || fault.empty()) << scene << "\n" << fault;
        const std::string shown = loaded ? "" : format(loaded.error());
        const bool wrong_kind = std::regex_search(shown, std::regex("is an? [a-z ]+, not "));
        EXPECT_TRUE(!wrong_kind || !fault.empty()) << scene << "\n" << shown;
        accepted += loaded.has_value();
        refused += wrong_kind;
      }
  EXPECT_GT(accepted, 50u);
  EXPECT_GT(refused, 200u);
}

TEST(SceneSchema, TakesAlternativesAndChoicesAmongChoices) {
  const SchemaCheck check = schema();
  const std::string segment = "segment = { from = [0, 0], to = [1, 0] }",
                    entity = "flatray = 1\n[[entity]]\nshape = { " + segment + " }\n";
  for (const std::string& line :
       {"alternatives = [{ " + segment + " }]",
        std::string("angle = { choice = [0, { choice = [1, { uniform = [2, 3] }] }] }")}) {
    EXPECT_EQ(check.fault(json_of(entity + line)), "") << line;
    EXPECT_TRUE(load_scene_text("t.toml", entity + line)) << line;
  }
  EXPECT_NE(check.fault(json_of(entity + "alternatives = [{ segment = { from = [0, 0] } }]")), "");
}

TEST(SceneSchema, OffersCurvesWhereTheProgramTakesThem) {
  const SchemaCheck check = schema();
  const std::string curve = "{ keys = [[0, 1], [1, 2]] }";
  const auto shape = [](const std::string& text) {
    return "flatray = 1\n[[entity]]\nshape = { " + text + " }\n";
  };
  const std::string taken[] = {
      shape("circle = { radius = " + curve + " }"),
      shape("box = { min = [0, 0], max = [9, " + curve + "] }"),
      shape("box = { min = [0, 0], max = { keys = [[0, [1, 2]]] } }"),
      shape("convex = { points = [[0, 0], [1, 0], { keys = [[0, [1, 2]]] }] }"),
      "flatray = 1\n[[group]]\nname = \"g\"\nscale = " + curve,
      shape("circle = { radius = 1 }") + "fill = { keys = [[0, \"#123456\"]] }"};
  for (const std::string& text : taken) {
    EXPECT_EQ(check.fault(json_of(text)), "") << text;
    EXPECT_TRUE(load_scene_text("t.toml", text)) << text;
  }
  const std::string refused[] = {
      shape("ngon = { sides = " + curve + ", radius = 1 }"),
      shape("import = { file = \"a.obj\", scale = " + curve + " }"),
      "flatray = 1\nfilm = { background = { keys = [[0, \"#123456\"]] } }"};
  for (const std::string& text : refused) EXPECT_NE(check.fault(json_of(text)), "") << text;
}

}  // namespace
}  // namespace flatray
