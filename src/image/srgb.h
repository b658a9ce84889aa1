#pragma once
#include <cstdint>

namespace flatray {

/// Linear light in [0, 1] of an 8-bit sRGB value: IEC 61966-2-1, rounded to float.
float linear_from_srgb(std::uint8_t value);

/// Nearest 8-bit sRGB value of linear light, clamped to [0, 1]; NaN is 0. The inverse of the above
/// on its values.
std::uint8_t srgb_from_linear(float light);

}  // namespace flatray
