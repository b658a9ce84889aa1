#pragma once
#include "base/light.h"

namespace flatray {

/// Nearest 8-bit sRGB value of linear light, clamped to [0, 1]; NaN is 0. The inverse of
/// linear_from_srgb on its values.
std::uint8_t srgb_from_linear(float light);

}  // namespace flatray
