#pragma once
#include <span>
#include <string>
#include <vector>

#include "scene/reading/scene_desc.h"

namespace flatray {

/// One key of the scene language: the same entry reads it, checks its spelling and documents it.
struct KeyInfo {
  const char* name;
  const char* takes;     ///< what to write after "=": "[x, y]"
  const char* fallback;  ///< the default as documented; kRequired where there is none
};
/// One array with one address, which is what a key without a default is told by.
inline constexpr char kRequired[] = "required";

/// The keys of one table, in the order of the documentation.
struct TableInfo {
  std::string table;
  std::vector<KeyInfo> keys;
  bool drawn = false;  ///< its numbers, points, colours and shapes may be drawn at random
};

/// What `{ NAME = { ... } }` chooses from where a key takes one of registered kinds.
struct KindInfo {
  const char* placeholder;  ///< NAME in KeyInfo::takes: "KIND"
  const char* key;          ///< as written: "shape"
  std::vector<TableInfo>
      tables;  ///< of each kind; of shapes by their names, "lamp.point" of others
  /// The name of a kind as it is written: "point".
  static std::string name(const TableInfo& table) {
    return table.table.substr(table.table.find('.') + 1);
  }
};
std::vector<KindInfo> kinds();

/// Every table of the language, kinds included: for documents, completion and tests.
std::vector<TableInfo> vocabulary();

/// One problem for each member of `table` that `keys` does not hold, with the nearest key, and for
/// each required key that it lacks.
void check_keys(const Value& table, std::string_view table_name, std::span<const KeyInfo> keys,
                Diagnostics& problems);

/// "unknown WHAT 'word' (did you mean 'near'?)", with all of `known` as the hint where none is
/// near.
Diagnostic unknown_word(Place where, std::string_view what, std::string_view word,
                        const std::vector<std::string>& known);

}  // namespace flatray
