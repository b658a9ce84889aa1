#pragma once
#include <fmt/core.h>

#include "scene/reading/reader.h"

namespace flatray {

/// The kind chosen by `{ KIND = { ... } }` and its arguments, of registered types with a `name`.
template <class Type>
struct Kind {
  const Type* type;
  const Value& arguments;
};

/// Reads which kind it is. What is wrong is noted; `what` names it in messages, "a shape".
template <class Type>
std::optional<Kind<Type>> read_kind(Reader& in, const Field& field,
                                    const std::vector<const Type*>& types, const char* what) {
  if (!in.is(field, Value::Kind::table, what)) return std::nullopt;
  if (field.value.members.size() != 1)
    return in.refuse(field, fmt::format("has {} kinds, not one", field.value.members.size()),
                     "write one of: " + comma_list(names_of(types)));
  const Member& kind = field.value.members.front();
  for (const Type* type : types) {
    if (kind.key != type->name) continue;
    const Field arguments{type->name, kind.value, "{ ... }"};
    if (!in.is(arguments, Value::Kind::table, "a table")) return std::nullopt;
    return Kind<Type>{type, kind.value};
  }
  return in.refuse(
      unknown_word(kind.where, std::string_view(what).substr(2), kind.key, names_of(types)));
}

}  // namespace flatray
