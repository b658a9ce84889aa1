// JSON as values with places.
#include "scene/reading/json_value.h"

#include "scene/scene_text.h"

namespace flatray {
namespace {

Result<Value> json(std::string text) {
  const auto source = std::make_shared<const SourceText>("t.json", std::move(text));
  return json_value(source, 0, source->text().size());
}
std::string json_refusal(std::string text) {
  const auto value = json(std::move(text));
  return value ? "" : format(value.error());
}

TEST(JsonValue, HasKindsTextsAndPlaces) {
  const auto value = json("{\n \"a\": [1, -2.5e-3, null],\n \"b\": {\"c\": true, \"d\": \"x\"}}\n");
  ASSERT_TRUE(value) << format(value.error());
  ASSERT_EQ(value->kind, Value::Kind::table);
  const Value& a = value->find("a")->value;
  ASSERT_EQ(a.items.size(), 3U);
  EXPECT_EQ(source_text(a.items[1]), "-2.5e-3");
  EXPECT_EQ(a.items[2].kind, Value::Kind::number);
  EXPECT_EQ(a.items[2].text, "null");
  const Place at = a.items[1].where;
  EXPECT_EQ(at.source->position(at.offset).line, 2);
  EXPECT_EQ(at.source->position(at.offset).column, 11);
  EXPECT_EQ(value->find("b")->value.find("d")->value.text, "x");
  EXPECT_EQ(value->find("b")->where.length, 3U);
}

TEST(JsonValue, EscapesAreCharacters) {
  const auto value = json(R"(["\"\\\/\b\f\n\r\t", "\u0041\u00e9\u20ac", "\ud83d\ude00"])");
  ASSERT_TRUE(value) << format(value.error());
  EXPECT_EQ(value->items[0].text, "\"\\/\b\f\n\r\t");
  EXPECT_EQ(value->items[1].text, "A\xc3\xa9\xe2\x82\xac");
  EXPECT_EQ(value->items[2].text, "\xf0\x9f\x98\x80");
}

TEST(JsonValue, MistakesAreToldWhereTheyStand) {
  const std::vector<Refused> cases = {
      {"", "t.json: error: a value is missing"},
      {"[1,\n 02]", "t.json:2:3: error: a number begins with 0"},
      {"[1.]", "t.json:1:4: error: a digit is missing"},
      {"[1 2]", "t.json:1:4: error: ',' or ']' is missing"},
      {"{\"a\" 1}", "t.json:1:6: error: ':' is missing"},
      {"{a: 1}", "a name in quotes is missing"},
      {"{\"a\": 1, \"a\": 2}", "t.json:1:10: error: this name is given twice"},
      {"[1]]", "t.json:1:4: error: more than one value"},
      {"[nan]", "no JSON value begins like this"},
      {"\"a\nb\"", "a control character"},
      {"\"\\ud800\"", "half of a surrogate pair"},
      {"\"\\udc00\"", "half of a surrogate pair"},
      {"\"\\x\"", "no such escape"},
      {"\"abc", "the text ends inside of quotes"},
      {"[\"\xff\"]", "t.json:1:3: error: this byte is not UTF-8"},
      {std::string(65, '['), "nested more than 64 deep"},
  };
  expect_refused(cases, &json_refusal);
}

TEST(JsonValue, NestedSixtyFourDeepIsRead) {
  EXPECT_TRUE(json(std::string(64, '[') + std::string(64, ']')));
}

TEST(JsonValue, AnyStartOfATextIsRefused) {
  const std::string text = R"({"a": [1, "\u00e9", {"b": null}], "c": -1.5e+3})";
  for (std::size_t size = 0; size < text.size(); ++size)
    EXPECT_FALSE(json(text.substr(0, size))) << size;
  EXPECT_TRUE(json(text));
}

}  // namespace
}  // namespace flatray
