#pragma once
#include <string_view>
#include <vector>

namespace flatray {

/// A text in the font that comes with stb: squares on a grid, the same on every machine.
struct FontPixel {
  int x, y;  ///< of the lower left corner; y = 0 stands on the baseline
};
struct FontLine {
  std::vector<FontPixel> pixels;  ///< each once
  int width;
};
inline constexpr int kFontCapitals = 7;   ///< pixels a capital is high
inline constexpr int kFontLineStep = 12;  ///< from baseline to baseline

/// Needs   a line of characters from ' ' to '~', at most 4096.
FontLine font_line(std::string_view text);

}  // namespace flatray
