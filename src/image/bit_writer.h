#pragma once
#include <bit>
#include <cstdint>
#include <cstring>

namespace flatray {

/// Writes bits, the first into the lowest bit of a byte.
///
/// Needs   room for 8 bytes beyond what is written; at most 56 bits put between two flushes.
class BitWriter {
 public:
  explicit BitWriter(std::byte* at) : at_(at) {}

  void put(std::uint64_t value, std::uint32_t bits) {
    held_ |= value << count_;
    count_ += bits;
  }
  void flush() {
    const std::uint64_t word =
        std::endian::native == std::endian::little ? held_ : __builtin_bswap64(held_);
    std::memcpy(at_, &word, sizeof word);
    at_ += count_ >> 3;
    held_ >>= count_ & ~7U;
    count_ &= 7;
  }
  /// Fills up the byte begun. Gives   where the next one goes.
  std::byte* finish() {
    flush();
    if (count_ > 0) ++at_;
    held_ = count_ = 0;
    return at_;
  }

 private:
  std::byte* at_;
  std::uint64_t held_ = 0;
  std::uint32_t count_ = 0;
};

}  // namespace flatray
