#pragma once
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace flatray {

/// Of registered entries the one of that name; null where this build has none.
template <class Entry>
const Entry* entry_named(const std::vector<const Entry*>& entries, std::string_view name) {
  const auto found = std::ranges::find(entries, name, &Entry::name);
  return found == entries.end() ? nullptr : *found;
}

/// A name with the letters of ASCII in lower case.
inline std::string lower_case(std::string name) {
  for (char& c : name) c = 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return name;
}

/// Names of entries, of pointers to them, or of pairs that begin with a name.
template <class Entries>
std::vector<std::string> names_of(const Entries& entries) {
  std::vector<std::string> names;
  for (const auto& entry : entries) {
    if constexpr (requires { entry->name; })
      names.emplace_back(entry->name);
    else if constexpr (requires { entry.name; })
      names.emplace_back(entry.name);
    else
      names.emplace_back(entry.first);
  }
  return names;
}

}  // namespace flatray
