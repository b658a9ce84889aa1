#pragma once
#include "scene/reading/scene_desc.h"

namespace flatray {

/// A member of a table that no one wrote, at the place of its value.
inline Member member(const char* key, Value value) { return {key, value.where, std::move(value)}; }

/// A table of such members in this order. None is copied, as those of a braced list are.
template <class... Members>
Value table_of(Place where, Members... members) {
  std::vector<Member> all;
  all.reserve(sizeof...(members));
  (all.push_back(std::move(members)), ...);
  return table_value(std::move(where), std::move(all));
}

}  // namespace flatray
