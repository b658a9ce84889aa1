#include "base/diagnostic.h"

#include <fmt/core.h>

#include <algorithm>
#include <numeric>

#include "base/shown_text.h"

namespace flatray {
namespace {

// A line of the source as shown below a message: at most this many bytes, around the value.
constexpr std::size_t kExcerptWidth = 100;

// A byte of UTF-8 that goes on with a character begun before.
bool continues(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

// The start of the character `at` lies in: at most three bytes before it.
std::size_t character_start(std::string_view line, std::size_t at) {
  for (std::size_t back = 0; back < 4 && back <= at && at < line.size(); ++back)
    if (!continues(line[at - back])) return at - back;
  return at;
}

// Tabs as blanks, so that an indented line looks as it does in the file.
std::string shown_line(std::string_view line) {
  std::string blank(line);
  std::replace(blank.begin(), blank.end(), '\t', ' ');
  return shown_text(blank);
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
  const std::string before = shown_line(line.substr(0, column));
  const std::size_t marked = shown_width(shown_line(line.substr(column, where.length)));
  return fmt::format("    {}{}\n    {}^{}{}{}\n", before, shown_line(line.substr(column)),
                     std::string(shown_width(before), ' '),
                     std::string(std::max<std::size_t>(marked, 1) - 1, '~'),
                     hint.empty() ? "" : "  ", shown_text(hint));
}

// Characters to change, to add, to leave out, or to swap with their neighbour (optimal string
// alignment).
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1), last = row, before = row;
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    before.swap(last);
    last = row;
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t change = last[j] + (a[i] == b[j] ? 0 : 1);
      row[j + 1] = std::min({change, row[j] + 1, last[j + 1] + 1});
      if (i > 0 && j > 0 && a[i] == b[j - 1] && a[i - 1] == b[j])
        row[j + 1] = std::min(row[j + 1], before[j - 1] + 1);
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
    all += fmt::format("    named at {}:{}:{}\n", shown_text(at->source->name()), position.line,
                       position.column);
  }
  return all;
}

}  // namespace

std::string format(const Diagnostic& diagnostic, const char* severity) {
  const auto& [where, message, hint, trouble] = diagnostic;
  if (!where || where.source->text().empty()) {
    const std::string name = where ? shown_text(where.source->name()) + ": " : "";
    const std::string tail = hint.empty() ? "" : fmt::format("\n    {}", shown_text(hint));
    return fmt::format("{}{}: {}{}\n{}", name, severity, shown_text(shortened(message)), tail,
                       where ? named_from(where) : "");
  }
  const SourceText::Position at = where.source->position(where.offset);
  return fmt::format("{}:{}:{}: {}: {}\n{}{}", shown_text(where.source->name()), at.line, at.column,
                     severity, shown_text(shortened(message)), excerpt(where, at, hint),
                     named_from(where));
}

std::string format(const Diagnostics& diagnostics, const char* severity) {
  std::string all;
  for (const Diagnostic& one : diagnostics) all += format(one, severity);
  return all;
}

std::string called(std::string_view what, std::string_view name, const Place& where) {
  if (!name.empty()) return fmt::format("{} '{}'", what, name);
  if (!where || where.source->text().empty()) return fmt::format("an unnamed {}", what);
  return fmt::format("{} of line {}", what, where.source->position(where.offset).line);
}

std::string comma_list(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
  return list;
}

std::string nearest_word(std::string_view word, const std::vector<std::string>& known) {
  std::string best;
  std::size_t best_distance = std::max<std::size_t>(word.size() / 3, 1) + 1;
  if (word.size() < 2 || word.size() > 64) return best;
  for (const std::string& candidate : known) {
    const auto [shorter, longer] = std::minmax({word.size(), candidate.size()});
    if (longer - shorter >= best_distance) continue;
    const std::size_t distance = edit_distance(word, candidate);
    if (distance < best_distance) best = candidate, best_distance = distance;
  }
  return best;
}

}  // namespace flatray
