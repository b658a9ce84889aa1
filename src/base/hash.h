#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace flatray {

/// 64-bit FNV-1a. For telling versions of a scene or picture apart, not for security.
class Hash {
 public:
  Hash& add(std::span<const std::byte> bytes);
  Hash& add(std::string_view text);
  Hash& add(std::uint64_t number);
  std::uint64_t value() const { return value_; }
  /// Sixteen lower-case hexadecimal digits.
  std::string hex() const;

 private:
  std::uint64_t value_ = 0xcbf29ce484222325U;
};

}  // namespace flatray
