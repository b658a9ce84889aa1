#pragma once
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace flatray {

/// `srgb_from_linear` as a table, for loops over pixels: one load, one sum, one shift a channel.
///
/// The upper 16 bits of a float in [2^-13, 1) name a bucket, narrow enough to hold at most one of
/// the 255 limits at which the nearest sRGB value changes. A bucket's entry is the value below its
/// limit times 2^16, plus what the lower 16 bits of a float at or above the limit make overflow.
/// Gives   the exact nearest value: limits are midpoints of neighbouring sRGB values, halves up.
class SrgbEncoder {
 public:
  static const SrgbEncoder& get();

  std::uint8_t operator()(float light) const {
    light = light > kLowest ? light : kLowest;  // NaN too
    light = light < kHighest ? light : kHighest;
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(light) - kFirst;
    return static_cast<std::uint8_t>((entries_[bits >> 16] + (bits & 0xffff)) >> 16);
  }

 private:
  SrgbEncoder();

  static constexpr float kLowest = 0x1p-13F, kHighest = 0x1.fffffep-1F;
  static constexpr std::uint32_t kFirst = std::bit_cast<std::uint32_t>(kLowest);
  static constexpr std::size_t kBuckets =
      ((std::bit_cast<std::uint32_t>(kHighest) - kFirst) >> 16) + 1;
  std::array<std::uint32_t, kBuckets> entries_;
};

}  // namespace flatray
