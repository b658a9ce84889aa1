#pragma once
#include <functional>
#include <string>

#include "geom/vec.h"
#include "image/image.h"
#include "study/experiment.h"

namespace flatray {

/// Linear light, 0 to 1 each.
struct Light {
  double r = 0, g = 0, b = 0;
  Light operator*(double factor) const { return {r * factor, g * factor, b * factor}; }
  Light& operator+=(const Light& other);
};

/// Full colours round the circle: hue 0 and 1 are the same.
Light hue(double turn);
/// Colours that are easy to tell apart, any number of them: the seven of Okabe and Ito, then the hue
/// goes on by the golden section.
Light nth_colour(std::size_t n);
/// From black over red and yellow to white, for 0 to 1.
Light heat(double level);

/// Hue of a direction.
Light hue_of(const Vec2& direction);

/// As sRGB, "#rrggbb", and back.
std::string hex(const Light& light);
Light light_of_hex(const std::string& hex);

/// Light as a picture, rows top-down, by the number of each pixel.
Image image_of(int width, int height, const std::function<Light(std::size_t)>& light);

/// A picture among the files of an experiment.
ExperimentResult::File png_file(const std::string& name, const Image& image, unsigned threads);

}  // namespace flatray
