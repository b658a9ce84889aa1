#pragma once
#include <string>
#include <string_view>

namespace flatray {

/// Text of others - names in scenes, files, command lines - as it may reach a terminal or a table.
///
/// Gives   the text itself, but as escapes of JSON and TOML what would steer a terminal or another
///         reader: control characters (of ASCII, and U+0080 to U+009F), ends of lines (U+2028, U+2029
///         too) and those that turn the direction of what follows (U+202A to U+202E, U+2066 to
///         U+2069); bytes that are no UTF-8 as "\xff".
std::string shown_text(std::string_view text);
/// The same of many lines: their ends and tabs stay.
std::string shown_lines(std::string text);

/// A message that quotes text of others: of more than 4000 bytes at most the first 4000, and "...".
std::string shortened(std::string_view message);

/// The text itself, but for bytes that are no UTF-8, which are shown as above.
std::string with_stray_bytes_shown(std::string_view text);

/// Columns a terminal gives to text that is shown, narrow characters as they mostly are.
std::size_t shown_width(std::string_view shown);

/// A text as one word of a POSIX shell, in quotes where it needs them: of commands that are shown to be
/// pasted. What shown_text() changes is in $'...', with bytes as "\ooo".
std::string shell_word(std::string_view text);

/// A text as a field of CSV (RFC 4180), shown as above. What begins with = + - or @ and is no number or
/// fraction, a formula where a spreadsheet opens the table, has an apostrophe before it.
std::string csv_field(std::string_view text);

}  // namespace flatray
