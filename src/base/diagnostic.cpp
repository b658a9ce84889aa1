#include "base/diagnostic.h"

#include <fmt/core.h>

#include <algorithm>
#include <numeric>

#include "base/utf8.h"

namespace flatray {
namespace {

// A line of the source as shown below a message: at most this many bytes, around the value.
constexpr std::size_t kExcerptWidth = 100;

// A byte of UTF-8 that goes on with a character begun before.
bool continues(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

// What must not reach a terminal from a hostile input: bytes that are no UTF-8, control characters
// (those of ASCII, and C2 80 to C2 9F), and those that turn the direction of what follows (U+202A to
// U+202E, U+2066 to U+2069).
bool is_shown(std::string_view character) {
  const auto last = static_cast<unsigned char>(character.back());
  if (character.size() == 1) return last >= 0x20 && last != 0x7f;
  const std::string_view lead = character.substr(0, character.size() - 1);
  return !(lead == "\xc2" && last < 0xa0) &&
         !(lead == "\xe2\x80" && last >= 0xaa && last <= 0xae) &&
         !(lead == "\xe2\x81" && last >= 0xa6 && last <= 0xa9);
}

std::string printable(std::string_view bytes) {
  std::string shown;
  shown.reserve(bytes.size());
  while (!bytes.empty()) {
    const std::size_t length = utf8_length(bytes);
    const std::string_view character = bytes.substr(0, std::max<std::size_t>(length, 1));
    if (character == "\t")
      shown += ' ';
    else if (length == 0 || !is_shown(character))
      shown += '?';
    else
      shown += character;
    bytes.remove_prefix(character.size());
  }
  return shown;
}

// Columns a terminal gives to what is printed of the bytes, narrow characters as they mostly are.
std::size_t shown_width(std::string_view bytes) {
  const std::string shown = printable(bytes);
  return static_cast<std::size_t>(
      std::count_if(shown.begin(), shown.end(), [](char c) { return !continues(c); }));
}

// The start of the character `at` lies in: at most three bytes before it.
std::size_t character_start(std::string_view line, std::size_t at) {
  for (std::size_t back = 0; back < 4 && back <= at && at < line.size(); ++back)
    if (!continues(line[at - back])) return at - back;
  return at;
}

std::string excerpt(const Place& where, SourceText::Position at, const std::string& hint) {
  std::string_view line = where.source->line(at.line);
  std::size_t column = static_cast<std::size_t>(at.column) - 1;
  std::size_t cut = 0;
  if (line.size() > kExcerptWidth && column > kExcerptWidth / 2) cut = column - kExcerptWidth / 2;
  cut = character_start(line, std::min(cut, line.size()));
  line.remove_prefix(cut);
  line = line.substr(0, character_start(line, std::min(line.size(), kExcerptWidth)));
  column = std::min(column - cut, line.size());
  const std::size_t marked = shown_width(line.substr(column, where.length));
  return fmt::format("    {}\n    {}^{}{}{}\n", printable(line),
                     std::string(shown_width(line.substr(0, column)), ' '),
                     std::string(std::max<std::size_t>(marked, 1) - 1, '~'),
                     hint.empty() ? "" : "  ", printable(hint));
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t change = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({change, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

// The way from the file of a mistake to the one the user named: the nearest steps of a long one.
std::string named_from(const Place& where) {
  constexpr int kShown = 8;
  std::string all;
  const Place* at = where.source->named_at();
  for (int i = 0; at != nullptr && at->source && i < kShown; ++i, at = at->source->named_at()) {
    const SourceText::Position position = at->source->position(at->offset);
    all += fmt::format("    named at {}:{}:{}\n", printable(at->source->name()), position.line,
                       position.column);
  }
  return all;
}

}  // namespace

std::string format(const Diagnostic& diagnostic, const char* severity) {
  const auto& [where, message, hint, trouble] = diagnostic;
  if (!where || where.source->text().empty()) {
    const std::string name = where ? printable(where.source->name()) + ": " : "";
    const std::string tail = hint.empty() ? "" : fmt::format("\n    {}", printable(hint));
    return fmt::format("{}{}: {}{}\n{}", name, severity, printable(message), tail,
                       where ? named_from(where) : "");
  }
  const SourceText::Position at = where.source->position(where.offset);
  return fmt::format("{}:{}:{}: {}: {}\n{}{}", printable(where.source->name()), at.line, at.column,
                     severity, printable(message), excerpt(where, at, hint), named_from(where));
}

std::string format(const Diagnostics& diagnostics, const char* severity) {
  std::string all;
  for (const Diagnostic& one : diagnostics) all += format(one, severity);
  return all;
}

std::string nearest_word(std::string_view word, const std::vector<std::string>& known) {
  std::string best;
  std::size_t best_distance = std::max<std::size_t>(word.size() / 3, 1) + 1;
  if (word.size() > 64) return best;
  for (const std::string& candidate : known) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance < best_distance) best = candidate, best_distance = distance;
  }
  return best;
}

}  // namespace flatray
