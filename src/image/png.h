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

/// A picture as PNG, by the encoder of this build. No time stamps: the same picture gives the same
/// bytes, whatever `threads`; with encoder `own`, on every machine.
std::vector<std::byte> encode_png(const Image& image, unsigned threads = 1);

/// A band of rows as PNG holds it: an IDAT chunk that depends on these rows alone, so that what did
/// not change need not be packed again.
struct PngBand {
  std::vector<std::byte> chunk;
  std::uint32_t adler = 1;
  std::uint64_t unpacked_bytes = 0;
};

/// What is kept of one picture for the next, by writers that can.
struct PngBands {
  int width = 0, height = 0, channels = 0;
  std::vector<PngBand> bands;
  std::uint64_t packed = 0, kept = 0;  ///< bands, of all pictures
};

/// Whether rows [begin, end) may differ from those of the picture before.
using RowsChanged = std::function<bool(int begin, int end)>;

/// A way to write PNG: a file in `encoders/` and a line in CMake.
struct PngWriter {
  const char* name;
  const char* summary;
  std::vector<std::byte> (*encode)(const Image& image, unsigned threads, const RowsChanged& changed,
                                   PngBands& kept);
};
/// Registered encoders by name; the first one writes: `own`, and `stb` in a build without it
/// (docs/adr/0029-png-encoders.md).
std::vector<const PngWriter*> png_writers();

/// Encodes pictures of a sequence: bands of rows that did not change may keep their chunks. The bytes
/// are those of `encode_png`.
class PngEncoder {
 public:
  explicit PngEncoder(unsigned threads, const PngWriter& writer = *png_writers().front())
      : threads_(threads), writer_(writer) {}

  /// `changed` is only asked of pictures of the same size and channels.
  std::vector<std::byte> encode(const Image& image, const RowsChanged& changed) {
    return writer_.encode(image, threads_, changed, bands_);
  }
  std::uint64_t packed() const { return bands_.packed; }  ///< bands, of all pictures
  std::uint64_t kept() const { return bands_.kept; }

 private:
  unsigned threads_;
  const PngWriter& writer_;
  PngBands bands_;
};

/// Reads a PNG of 1 to 4 channels as RGB, or RGBA if it has alpha; colours that its palette lacks are
/// black.
/// Error   Trouble::invalid for what is not a whole PNG (checksums included), for an animated one, or above
///         `max_pixels`, before any large allocation.
Result<Image> decode_png(std::span<const std::byte> bytes, const std::string& name,
                         std::uint64_t max_pixels = std::uint64_t{1} << 28);
Result<Image> read_png(const std::string& path);

}  // namespace flatray
