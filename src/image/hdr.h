#pragma once
#include "image/image.h"

namespace flatray {

/// Radiance RGBE by stb_image_write, linear sRGB primaries.
std::vector<std::byte> encode_hdr(const LinearImage& image);

}  // namespace flatray
