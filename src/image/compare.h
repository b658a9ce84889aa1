#pragma once
#include <string>

#include "image/image.h"

namespace flatray {

/// What differs between two pictures of one size and channel count, in levels or, of linear pictures,
/// in their light: the numbers of the file, whatever they count.
struct Difference {
  std::uint64_t pixels = 0;  ///< pixels with any channel different
  std::uint64_t of = 0;      ///< pixels in all
  double worst = 0;          ///< largest channel difference
  int x = 0, y = 0;          ///< of the first pixel with it, rows top-down
  int channel = 0;
  double actual = 0, expected = 0;
  double mean = 0;  ///< mean absolute channel difference
  double rmse = 0;
  double psnr =
      0;  ///< dB below 255 levels, or below the brightest light expected; infinity when equal
};

/// Error   Trouble::invalid when size or channels differ.
Result<Difference> compare(const Image& actual, const Image& expected);
/// The same of light. What is no number differs by infinity from all but itself.
Result<Difference> compare(const LinearImage& actual, const LinearImage& expected);

/// |actual - expected| times `gain`, clamped: for people to look at. Of light in parts of its mean,
/// which is white.
Image difference_image(const Image& actual, const Image& expected, int gain = 16);
Image difference_image(const LinearImage& actual, const LinearImage& expected, int gain = 16);

}  // namespace flatray
