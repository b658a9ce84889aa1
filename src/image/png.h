#pragma once
#include <span>

#include "image/image.h"

namespace flatray {

/// PNG by stb_image_write, libdeflate behind its hook where it is built in. No time stamps: same
/// picture, same bytes.
std::vector<std::byte> encode_png(const Image& image);

/// Reads a PNG of 1 to 4 channels as RGB, or RGBA if it has alpha.
/// Error   Trouble::invalid for what is no whole PNG (checksums included) or exceeds `max_pixels`,
///         before any large allocation.
Result<Image> decode_png(std::span<const std::byte> bytes, const std::string& name,
                         std::uint64_t max_pixels = std::uint64_t{1} << 28);
Result<Image> read_png(const std::string& path);

}  // namespace flatray
