#pragma once
#include <cstddef>
#include <optional>
#include <string_view>

namespace flatray {

/// What a TOML text would cost its parser, found without parsing it.
struct TomlLoad {
  std::size_t values = 0;                 ///< at least as many as it holds
  std::optional<std::size_t> deep_key{};  ///< byte at which a key has more than kMaxKeyParts parts
};
inline constexpr std::size_t kMaxKeyParts = 64;

/// Right for every text up to its first mistake of syntax, and a parser stops there. Strings and
/// comments are passed over.
TomlLoad scan_toml(std::string_view text);

}  // namespace flatray
