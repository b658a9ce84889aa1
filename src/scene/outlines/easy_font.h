#pragma once
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace flatray {

/// A text in the font that comes with stb: squares on a grid, the same on every machine.
struct FontPixel {
  int x, y;  ///< of the lower left corner; y = 0 stands on the baseline
};
struct FontLine {
  std::vector<FontPixel> pixels;  ///< each once
  int width;                      ///< pixels, to the end of its last character
};
inline constexpr int kFontCapitals = 7;   ///< pixels a capital is high
inline constexpr int kFontLineStep = 12;  ///< from baseline to baseline

/// Needs   a line of characters from ' ' to '~', at most 4096.
FontLine font_line(std::string_view text);

/// Adds the pixels of a line to a shape as squares of side `scale`, `start` pixels from its origin.
/// Neighbours share their corners to the bit, so that the outline of the shape is that of their
/// union.
void add_line(Shape& shape, const FontLine& line, const Vec2& start, double scale);

}  // namespace flatray
