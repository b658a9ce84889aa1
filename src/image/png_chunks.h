#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace flatray {

/// What a PNG says of itself before its pixels are unpacked.
struct PngHeader {
  std::uint32_t width = 0, height = 0;
  int bit_depth = 0, colour_type = 0;
  bool interlaced = false;
  bool alpha = false;                            ///< an alpha channel, or a transparent colour
  std::uint32_t frames = 1;                      ///< of an animated PNG; the pixels are the first
  std::size_t palette_at = 0, palette_size = 0;  ///< bytes of PLTE in the file
  std::vector<char> deflated;                    ///< all IDAT chunks joined

  /// Bytes the pixels unpack to: rows of samples, each after its filter byte.
  std::uint64_t unpacked_bytes() const;
};

/// The highest byte first.
void put_number(std::vector<std::byte>& out, std::uint32_t number);

/// A chunk at the end of `out`: what is put there until `end` are its data.
class PngChunk {
 public:
  PngChunk(std::vector<std::byte>& out, std::string_view type);
  void end();

 private:
  std::vector<std::byte>& out_;
  std::size_t begin_;
};

/// Walks the chunks of a PNG, as ISO/IEC 15948 has them.
///
/// Gives   the header of a file that is whole: signature, IHDR first, IDAT chunks together, IEND
///         last with nothing behind it, every CRC-32 right, no unknown critical chunk.
/// Error   Trouble::invalid, with the byte where the file goes wrong, also above `max_pixels`.
/// Cost    allocates no more than the file's size.
Result<PngHeader> read_png_chunks(std::span<const std::byte> bytes, const std::string& name,
                                  std::uint64_t max_pixels);

}  // namespace flatray
