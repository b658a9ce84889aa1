#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "image/image.h"

namespace flatray {

/// Numbers of scrambles from which an error can be told.
inline constexpr unsigned kScrambles[] = {16, 32, 64};

/// Sums of a film for each scramble, row by row, three channels a pixel: independent pictures of one
/// light, all of as many rays.
using ScrambleSums = std::span<const std::vector<std::int64_t>>;

/// Relative standard error of the picture that is the mean of the scrambles: the standard errors of
/// the luminance of all pixels, together, over all of their light; none where no light came.
/// Needs   at least two scrambles.
std::optional<double> relative_error(ScrambleSums sums);

/// Half the width of the interval that holds each channel of each pixel with 95 %, in the units of
/// the light: `film_unit` of a unit of the sums of one scramble. NaN where so little light fell that
/// it may be that of fewer than kFewestRays crossings.
/// Needs   a number of kScrambles.
LinearImage error_image(ScrambleSums sums, double film_unit, int width, int height);
inline constexpr std::int64_t kFewestRays = 100;

/// The same in parts of the luminance, as grey from black to white, which is 1 or more; clear where
/// there is no number.
Image shown_error(ScrambleSums sums, int width, int height);

}  // namespace flatray
