#include "base/hash.h"

#include <fmt/core.h>

namespace flatray {

Hash& Hash::add(std::span<const std::byte> bytes) {
  for (const std::byte b : bytes)
    value_ = (value_ ^ static_cast<std::uint64_t>(b)) * 0x100000001b3U;
  return *this;
}

Hash& Hash::add(std::string_view text) {
  add(static_cast<std::uint64_t>(text.size()));  // so that ("ab", "c") and ("a", "bc") differ
  return add(std::as_bytes(std::span(text)));
}

Hash& Hash::add(std::uint64_t number) {
  for (int shift = 0; shift < 64; shift += 8)
    value_ = (value_ ^ ((number >> shift) & 0xff)) * 0x100000001b3U;
  return *this;
}

std::string Hash::hex() const { return fmt::format("{:016x}", value_); }

}  // namespace flatray
