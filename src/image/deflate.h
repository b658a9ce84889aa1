#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace flatray {

/// Part of the bytes as deflate has it: literals, then `length` bytes that repeat those `distance`
/// before. length 0: no more bytes; else 3 or more, also above 258.
struct Sequence {
  std::uint32_t literals, length, distance;
};

/// Finds repetitions in filtered rows of pixels: zeros, the pixel before, and the last place the
/// next six bytes were seen at. Its room is kept from call to call.
class MatchFinder {
 public:
  /// Needs   fewer than 2^31 bytes; `pixel` <= 8, the bytes of one.
  /// Cost    O(bytes); where little repeats, ever fewer places are looked at.
  const std::vector<Sequence>& find(std::span<const std::uint8_t> bytes, std::size_t pixel);

 private:
  static constexpr unsigned kHashBits = 12;

  std::vector<Sequence> sequences_;
  std::array<std::uint32_t, std::size_t{1} << kHashBits> seen_;
};

/// Packs rows of pixels as whole blocks of deflate (RFC 1951), one Huffman code for each call.
///
/// Gives   appended to `out`: blocks of which none is the last, ending on a whole byte, so that
///         what is packed apart can be joined. The same bytes on every machine.
/// Error   never above 5 bytes for every 65535, and 5, more than `bytes`.
class Deflater {
 public:
  void pack(std::span<const std::uint8_t> bytes, std::size_t pixel, std::vector<std::byte>& out);

 private:
  MatchFinder finder_;
};

}  // namespace flatray
