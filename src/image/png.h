#pragma once
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string_view>

#include "image/image.h"

namespace flatray {

/// How every PNG begins.
inline constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";

/// Most bytes of a picture's file that are read.
inline constexpr std::size_t kMostPictureBytes = std::numeric_limits<int>::max();

/// A picture as PNG. No time stamps, and deflate of our own: the same picture gives the same bytes
/// on every machine, whatever `threads`.
std::vector<std::byte> encode_png(const Image& image, unsigned threads = 1);

/// A band of rows as PNG holds it: an IDAT chunk that depends on these rows alone, so that what did
/// not change need not be packed again.
struct PngBand {
  std::vector<std::byte> chunk;
  std::uint32_t adler = 1;
  std::uint64_t unpacked_bytes = 0;
};

/// Whether rows [begin, end) may differ from those of the picture before.
using RowsChanged = std::function<bool(int begin, int end)>;

/// Encodes pictures of a sequence: bands of rows that did not change keep their chunks. The bytes
/// are those of `encode_png`.
class PngEncoder {
 public:
  explicit PngEncoder(unsigned threads) : threads_(threads) {}

  /// `changed` is only asked of pictures of the same size and channels.
  std::vector<std::byte> encode(const Image& image, const RowsChanged& changed);
  std::uint64_t packed() const { return packed_; }  ///< bands, of all pictures
  std::uint64_t kept() const { return kept_; }

 private:
  unsigned threads_;
  int width_ = 0, height_ = 0, channels_ = 0;  ///< of the picture before
  std::vector<PngBand> bands_;
  std::uint64_t packed_ = 0, kept_ = 0;
};

/// Reads a PNG of 1 to 4 channels as RGB, or RGBA if it has alpha; colours that its palette lacks are
/// black.
/// Error   Trouble::invalid for what is not a whole PNG (checksums included) or exceeds `max_pixels`,
///         before any large allocation.
Result<Image> decode_png(std::span<const std::byte> bytes, const std::string& name,
                         std::uint64_t max_pixels = std::uint64_t{1} << 28);
Result<Image> read_png(const std::string& path);

}  // namespace flatray
