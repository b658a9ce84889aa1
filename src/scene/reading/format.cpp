#include "scene/reading/format.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

#include "base/entry_named.h"
#include "scene/load.h"

namespace flatray {

#include "formats.inc"  // formats()

const Format* find_format(std::string_view name) { return entry_named(formats(), name); }

std::string extension_of(std::string_view file_name) {
  const std::size_t point = file_name.rfind('.');
  if (point == std::string_view::npos) return {};
  std::string extension(file_name.substr(point + 1));
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return extension;
}

const Format* format_for_name(std::string_view file_name) {
  const std::string extension = extension_of(file_name);
  for (const Format* format : formats())
    for (const std::string_view known : format->extensions)
      if (known == extension) return format;
  return nullptr;
}

const Format* format_for_text(std::string_view text) {
  for (const Format* format : formats())
    if (format->recognises(text)) return format;
  return find_format("toml");
}

std::string known_extensions() {
  std::string all;
  for (const Format* format : formats())
    for (const std::string_view extension : format->extensions)
      all += fmt::format("{}.{}", all.empty() ? "" : ", ", extension);
  return all;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r\n\f\v";
  const std::size_t begin = text.find_first_not_of(kBlank);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlank) - begin + 1);
}

std::string_view first_line(std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = trimmed(text.substr(0, end));
    if (!line.empty() && line.front() != '#') return line;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return {};
}

std::string scene_name(std::string_view file_name) {
  return std::filesystem::path(file_name).stem().string();
}

}  // namespace flatray
