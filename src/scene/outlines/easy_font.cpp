#include "scene/outlines/easy_font.h"

#include <stb/stb_easy_font.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <tuple>

namespace flatray {
namespace {

// Of one of the four corners of a rectangle.
constexpr std::size_t kCornerBytes = 16, kMostBytesACharacter = 64 * 40;
constexpr int kBetweenLetters = 2;  // pixels, which stb counts behind the last one, too
constexpr int kBaseline = 7;        // below the top of a line, y pointing down

FontPixel corner(const char* bytes) {
  float xy[2];
  std::memcpy(xy, bytes, sizeof xy);
  return {static_cast<int>(xy[0]), static_cast<int>(xy[1])};
}

}  // namespace

FontLine font_line(std::string_view text) {
  std::string line(text);
  std::vector<char> corners(kMostBytesACharacter * (line.size() + 1));
  const int rectangles = stb_easy_font_print(0, 0, line.data(), nullptr, corners.data(),
                                             static_cast<int>(corners.size()));
  FontLine result{{}, std::max(stb_easy_font_width(line.data()) - kBetweenLetters, 0)};
  for (int i = 0; i < rectangles; ++i) {
    const char* first = corners.data() + static_cast<std::size_t>(i) * 4 * kCornerBytes;
    const FontPixel low = corner(first), high = corner(first + 2 * kCornerBytes);
    for (int y = low.y; y < high.y; ++y)
      for (int x = low.x; x < high.x; ++x) result.pixels.push_back({x, kBaseline - 1 - y});
  }
  const auto key = [](const FontPixel& p) { return std::tuple(p.y, p.x); };
  std::ranges::sort(result.pixels, {}, key);
  const auto end =
      std::unique(result.pixels.begin(), result.pixels.end(),
                  [&](const FontPixel& a, const FontPixel& b) { return key(a) == key(b); });
  result.pixels.erase(end, result.pixels.end());
  return result;
}

void add_line(Shape& shape, const FontLine& line, const Vec2& start, double scale) {
  const auto corner = [&](int x, int y) {
    return Vec2((start.x() + x) * scale, (start.y() + y) * scale);
  };
  for (const FontPixel& pixel : line.pixels) {
    const int x = pixel.x, y = pixel.y;
    for (const Vec2& at :
         {corner(x, y), corner(x + 1, y), corner(x + 1, y + 1), corner(x, y + 1)}) {
      shape.edges.push_back(static_cast<std::int32_t>(shape.vertices.size()));
      shape.vertices.push_back(at);
    }
    shape.begin.push_back(static_cast<std::uint32_t>(shape.vertices.size()));
  }
}

}  // namespace flatray
