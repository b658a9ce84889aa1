#pragma once
#include <span>

#include "image/image.h"

namespace flatray {

/// Radiance RGBE by stb_image_write, linear sRGB primaries.
/// Error   1/256 of the brightest channel of a pixel, rounded to nearest.
std::vector<std::byte> encode_hdr(const LinearImage& image);

inline constexpr std::string_view kHdrSignature = "#?";  ///< what its bytes begin with
/// Reads what `encode_hdr` writes, and other RGBE files whose rows run from the top left; light by which
/// EXPOSURE multiplied it is divided.
/// Error   Trouble::invalid for another header, the runs of the oldest files, what is cut short or goes on,
///         and beyond `max_pixels`.
/// Cost    memory grows with the rows there are, not with those announced.
Result<LinearImage> decode_hdr(std::span<const std::byte> bytes, const std::string& name,
                               std::uint64_t max_pixels = std::uint64_t{1} << 28);
/// As a PNG would show it: light above 1 is 1.
Image develop(const LinearImage& light);

}  // namespace flatray
