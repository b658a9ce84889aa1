#pragma once
#include <algorithm>
#include <string_view>
#include <vector>

namespace flatray {

/// Of registered entries the one of that name; null where this build has none.
template <class Entry>
const Entry* entry_named(const std::vector<const Entry*>& entries, std::string_view name) {
  const auto found = std::ranges::find(entries, name, &Entry::name);
  return found == entries.end() ? nullptr : *found;
}

}  // namespace flatray
