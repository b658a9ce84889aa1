#pragma once
#include <string>

#include "image/image.h"

namespace flatray {

/// What differs between two pictures of one size and channel count.
struct Difference {
  std::uint64_t pixels = 0;  ///< pixels with any channel different
  int worst = 0;             ///< largest channel difference, levels
  int x = 0, y = 0;          ///< of the first pixel with it, rows top-down
  int channel = 0, actual = 0, expected = 0;
  double mean = 0;  ///< mean absolute channel difference, levels
  double rmse = 0;  ///< levels
  double psnr = 0;  ///< dB; infinity when equal
};

/// Error   Trouble::invalid when size or channels differ.
Result<Difference> compare(const Image& actual, const Image& expected);

/// |actual - expected| times `gain`, clamped: for people to look at.
Image difference_image(const Image& actual, const Image& expected, int gain = 16);

}  // namespace flatray
