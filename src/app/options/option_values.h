#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "geom/ray.h"
#include "render/pixel_box.h"
#include "scene/load.h"

namespace flatray {

/// Reads a text of digits alone. A number that 64 bits do not hold is given as the largest one,
/// which every range refuses.
std::optional<std::uint64_t> parse_whole(std::string_view text);

/// "60s" or "60".
std::optional<double> parse_seconds(std::string_view text);
/// Error   Trouble::usage: not above 0 and at most `most`.
Result<double> parse_time(std::string_view text, const Place& where, double most);

/// Most pixels --max-pixels may allow: what the 32-bit sizes of the PNG writer hold, four channels,
/// one pixel wide.
inline constexpr std::uint64_t kMostPixels = 400'000'000;

struct FilmSize {
  int width, height;
};
/// "WxH" in pixels.
/// Error   Trouble::usage naming width or height and the limit; nothing is allocated.
Result<FilmSize> parse_size(std::string_view text, const Place& where, std::uint64_t max_pixels);

/// "x0,y0,x1,y1": columns x0 to x1 - 1 and rows y0 to y1 - 1 from the top, inside a film.
Result<PixelBox> parse_crop(std::string_view text, const Place& where, const FilmSize& film);

/// "x,y,dx,dy".
Result<Ray> parse_ray(std::string_view text, const Place& where);

/// "key=value".
Result<Override> parse_override(const std::string& text, const Place& where);

/// Reads a time above 0: "60s" or "60".
inline auto time_up_to(double most) {
  return [=](const std::string& text, const Place& where) { return parse_time(text, where, most); };
}

/// Pieces of `text` between the characters `at`.
std::vector<std::string_view> split(std::string_view text, char at);

}  // namespace flatray
