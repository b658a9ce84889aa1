#pragma once
#include "image/image.h"

namespace flatray {

/// Root mean square of the differences of all channels. Needs   images of one size.
double rms_difference(const LinearImage& a, const LinearImage& b);

/// What linear light looks like on a screen.
Image developed(const LinearImage& light);

}  // namespace flatray
