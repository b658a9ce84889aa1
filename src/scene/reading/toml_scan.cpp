#include "scene/reading/toml_scan.h"

#include <algorithm>

namespace flatray {
namespace {

// One past the string that begins at `begin`, of any of the four kinds; unclosed ones end with
// their line or text.
std::size_t end_of_string(std::string_view text, std::size_t begin) {
  const char quote = text[begin];
  const bool basic = quote == '"';
  const bool long_form = text.substr(begin, 3) == std::string_view(basic ? "\"\"\"" : "'''");
  std::size_t i = begin + (long_form ? 3 : 1);
  for (; i < text.size(); ++i) {
    if (basic && text[i] == '\\')
      ++i;
    else if (!long_form && (text[i] == quote || text[i] == '\n'))
      return i + 1;
    else if (long_form && text.substr(i, 3) == std::string_view(basic ? "\"\"\"" : "'''"))
      break;
  }
  // Up to two quotes may stand before the three that close.
  i = std::min(i + 3, text.size());
  while (long_form && i < text.size() && text[i] == quote) ++i;
  return i;
}

}  // namespace

TomlLoad scan_toml(std::string_view text) {
  TomlLoad load;
  std::size_t parts = 1;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      i = end_of_string(text, i);
      continue;
    }
    if (c == '#') {
      i = std::min(text.find('\n', i), text.size());
      continue;
    }
    if (c == '.' && ++parts > kMaxKeyParts && !load.deep_key) load.deep_key = i;
    if (c == '=' || c == ',' || c == '[' || c == '{') ++load.values;
    if (c == '=' || c == ',' || c == '[' || c == '{' || c == '\n') parts = 1;
    ++i;
  }
  return load;
}

}  // namespace flatray
