#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace flatray {

struct Member;

/// One value of a scene as it was written, with its place. Numbers stay text until a key reads
/// them.
struct Value {
  enum class Kind { boolean, number, string, array, table, date };

  Kind kind = Kind::table;
  Place where;                  ///< of the whole value; a number's is its token
  std::string text;             ///< content of a string; "true" or "false"
  std::vector<Value> items;     ///< of an array
  std::vector<Member> members;  ///< of a table, in file order

  /// Member of a table, or nullptr.
  const Member* find(std::string_view key) const;
  Member* find(std::string_view key);
};

struct Member {
  std::string key;
  Place where;  ///< of the key
  Value value;
};

/// Whether a value stands for a curve: `{ keys = [...] }`.
bool is_curve(const Value& value);
/// Whether one stands anywhere in a value.
bool has_curve(const Value& value);
/// "a number", "a table", ...: for messages.
const char* kind_name(Value::Kind kind);
/// The bytes of the source a value was written with.
std::string_view source_text(const Value& value);

/// Values no one wrote, for importers: their source is called "built in".
Value built_in_number(double finite);
/// Many of them, which share one text.
std::vector<Value> built_in_numbers(std::span<const double> finite);
Value string_value(Place where, std::string text);
Value table_value(Place where, std::vector<Member> members);
Value array_value(Place where, std::vector<Value> items);

/// A value that an option put into a scene.
struct OptionText {
  SourcePtr source;
  std::size_t begin;  ///< of the value in it
  Place replaces;     ///< where that stood which it replaces; none of what is new
};

/// A scene before its meaning is checked.
struct SceneDesc {
  Value root;
  Diagnostics warnings{};            ///< of the importer
  bool ends = false;                 ///< Scene::ends
  std::vector<SourcePtr> sources{};  ///< the files it is made of, in the order of their entries
  std::vector<OptionText> options{};
};

/// The order of what a scene's files hold: that of their text, files included first. What an option
/// put there stands where what it replaced stood, or else after all, in the order of the options.
class TextOrder {
 public:
  TextOrder() = default;
  explicit TextOrder(const SceneDesc& desc);
  std::uint64_t at(const Place& place) const;
  bool is_in_a_file(const Place& place) const { return before_.contains(place.source.get()); }

 private:
  struct Inserted {
    OptionText text;
    std::uint64_t at;  ///< without what other options put before it
    std::uint64_t size() const { return text.source->text().size(); }
  };
  const Inserted* find(const SourceText* option) const;
  std::uint64_t in_files(const Place& place) const;

  std::map<const SourceText*, std::uint64_t> before_;  ///< bytes of the files before each
  std::vector<Inserted> options_;
};

}  // namespace flatray
