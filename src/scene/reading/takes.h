#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace flatray {

/// What a key takes, read from its `KeyInfo::takes`, so that the text people read is also the type
/// that editors check. The text is one or more of these, "A", "A or B", "A, B or C":
///
///   number, degrees, pixels, ...   a number, named by its unit; whole number, frames: a whole one
///   true or false                  a truth value
///   12                             that whole number
///   "word"                         that word
///   "NAME", "outline.obj"          any text: upper case, or a file
///   "#rrggbb"                      a colour
///   [A, B]  [A, ...]               so many of them; any number of A. A name alone is a number: [x, y]
///   [[ray]]  [markov.NAME]         tables of that kind; a table that holds them by name
///   { key = A, ... }               the table that has such keys; { NAME = A }: any names
///   { ... }                        the table called as the key
///   a curve                        the table called curve; the numbers beside it may be one, too
struct Takes {
  enum class Kind { number, whole, truth, literal, word, text, colour, list, table, tables, named };

  Kind kind = Kind::number;
  std::string
      text{};  ///< literal: digits; word: its letters; table, tables, named: the kind of table
  std::vector<std::vector<Takes>> items{};  ///< list: the alternatives of each
  bool more = false;                        ///< list: the last item any number of times
  std::vector<std::pair<std::string, std::vector<Takes>>> keys{};  ///< table
};

/// The alternatives of a text; nullopt where it does not follow the grammar above.
std::optional<std::vector<Takes>> parse_takes(std::string_view takes);

/// Whether a key or word stands for names the user chooses: "NAME", "STATE".
bool is_placeholder(std::string_view name);

}  // namespace flatray
