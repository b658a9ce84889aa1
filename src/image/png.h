#pragma once
#include <cstdint>
#include <span>

#include "image/image.h"

namespace flatray {

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

/// Packs the rows [y, y + band_rows(width)) of a picture (image/tile.h), fewer at its end.
PngBand pack_png_band(const Image& image, int y);
/// Joins all bands of a picture, from top to bottom.
std::vector<std::byte> join_png(int width, int height, int channels,
                                std::span<const PngBand> bands);

/// Reads a PNG of 1 to 4 channels as RGB, or RGBA if it has alpha.
/// Error   Trouble::invalid for what is no whole PNG (checksums included) or exceeds `max_pixels`,
///         before any large allocation.
Result<Image> decode_png(std::span<const std::byte> bytes, const std::string& name,
                         std::uint64_t max_pixels = std::uint64_t{1} << 28);
Result<Image> read_png(const std::string& path);

}  // namespace flatray
