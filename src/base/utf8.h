#pragma once
#include <cstddef>
#include <string_view>

namespace flatray {

/// Bytes of the character `text` begins with, 1 to 4; 0 where it begins with none: a byte out of
/// place, a form longer than needed, a surrogate, beyond U+10FFFF, cut short, or nothing.
std::size_t utf8_length(std::string_view text);

/// Where the first byte stands that is not UTF-8; the size of `text` if all of it is.
std::size_t utf8_prefix(std::string_view text);

}  // namespace flatray
