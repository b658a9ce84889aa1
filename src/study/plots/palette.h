#pragma once
#include <functional>
#include <string>

#include "geom/vec.h"
#include "image/image.h"
#include "study/experiment.h"

namespace flatray {

/// Linear light, 0 to 1 each.
struct LinearRgb {
  double r = 0, g = 0, b = 0;
  LinearRgb operator*(double factor) const { return {r * factor, g * factor, b * factor}; }
  LinearRgb& operator+=(const LinearRgb& other);
};

/// Full colours round the circle: hue 0 and 1 are the same.
LinearRgb hue(double turn);
/// Colours that are easy to tell apart, any number of them: the seven of Okabe and Ito, then the
/// hue goes on by the golden section.
LinearRgb nth_colour(std::size_t n);
/// From black to white, for 0 to 1.
inline LinearRgb grey(double level) { return {level, level, level}; }
/// From black over red and yellow to white, for 0 to 1.
LinearRgb heat(double level);

/// Hue of a direction.
LinearRgb hue_of(const Vec2& direction);

/// As sRGB, "#rrggbb", and back.
std::string hex(const LinearRgb& light);
LinearRgb light_of_hex(const std::string& hex);

/// Light as a picture, rows top-down, by the number of each pixel.
Image image_of(int width, int height, const std::function<LinearRgb(std::size_t)>& light);

/// A picture among the files of an experiment.
ExperimentResult::File png_file(const std::string& name, const Image& image, unsigned threads);

}  // namespace flatray
