#pragma once
#include <cstdint>

namespace flatray {

/// Linear light in [0, 1] of an sRGB value on the scale of 8 bits, fractions allowed: IEC 61966-2-1.
double light_of(double value);

/// The same of a whole one, rounded to float.
float linear_from_srgb(std::uint8_t value);

}  // namespace flatray
