#include "app/options/option_values.h"

#include <fmt/core.h>

#include <charconv>
#include <limits>

#include "app/options/arguments.h"
#include "base/counted.h"
#include "base/number_text.h"

namespace flatray {

std::optional<std::uint64_t> parse_whole(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size() || text.empty()) return std::nullopt;
  if (error == std::errc::result_out_of_range) return std::numeric_limits<std::uint64_t>::max();
  return value;
}

std::optional<double> parse_seconds(std::string_view text) {
  if (text.ends_with('s')) text.remove_suffix(1);
  return parse_number(text);
}

Result<double> parse_time(std::string_view text, const Place& where, double most) {
  const auto seconds = parse_seconds(text);
  if (!seconds || !(*seconds > 0))
    return usage_error(where, "is not a time above 0", "say 60 or 1.5s");
  if (*seconds > most)
    return usage_error(where, "is too long a time", fmt::format("say {}s at most", most));
  return *seconds;
}

std::vector<std::string_view> split(std::string_view text, char at) {
  std::vector<std::string_view> pieces;
  for (;;) {
    const std::size_t end = text.find(at);
    pieces.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return pieces;
    text.remove_prefix(end + 1);
  }
}

namespace {

Result<std::uint64_t> parse_side(std::string_view text, const char* side, const Place& where,
                                 std::uint64_t max_pixels) {
  const std::optional<std::uint64_t> value = parse_whole(text);
  if (!value)
    return usage_error(where, fmt::format("{} '{}' is not a whole number of pixels", side, text),
                       "say WIDTHxHEIGHT, as 1280x720");
  if (*value == 0)
    return usage_error(where, fmt::format("{} 0 leaves no picture", side), "say 1 or more");
  if (*value > max_pixels)
    return usage_error(where, fmt::format("{} {} is over the limit", side, text),
                       fmt::format("at most {}; --max-pixels N raises it up to {}",
                                   counted(max_pixels, "pixel"), kMostPixels));
  return *value;
}

}  // namespace

Result<FilmSize> parse_size(std::string_view text, const Place& where, std::uint64_t max_pixels) {
  const std::size_t x = text.find('x');
  if (x == std::string_view::npos)
    return usage_error(where, fmt::format("'{}' is not WIDTHxHEIGHT", text), "as 1280x720");
  FLATRAY_TRY(width, parse_side(text.substr(0, x), "width", where, max_pixels));
  FLATRAY_TRY(height, parse_side(text.substr(x + 1), "height", where, max_pixels));
  if (*width > max_pixels / *height)
    return usage_error(
        where,
        fmt::format("{} is {} pixels, over the limit of {}", text, *width * *height, max_pixels),
        fmt::format("--max-pixels N raises it up to {}", kMostPixels));
  return FilmSize{static_cast<int>(*width), static_cast<int>(*height)};
}

Result<PixelBox> parse_crop(std::string_view text, const Place& where, const FilmSize& film) {
  const std::vector<std::string_view> parts = split(text, ',');
  std::vector<int> at;
  for (const std::string_view part : parts) {
    const std::optional<std::uint64_t> value = parse_whole(part);
    const auto longest = static_cast<std::uint64_t>(std::max(film.width, film.height));
    if (value && *value <= longest) at.push_back(static_cast<int>(*value));
  }
  const bool fits = parts.size() == 4 && at.size() == 4 && at[0] < at[2] && at[1] < at[3] &&
                    at[2] <= film.width && at[3] <= film.height;
  if (!fits)
    return usage_error(
        where, fmt::format("'{}' is not part of a {}x{} picture", text, film.width, film.height),
        "say x0,y0,x1,y1 with 0 <= x0 < x1 <= width, 0 <= y0 < y1 <= height");
  return PixelBox{at[0], at[1], at[2] - at[0], at[3] - at[1]};
}

Result<Ray> parse_ray(std::string_view text, const Place& where) {
  std::vector<double> numbers;
  for (const std::string_view part : split(text, ','))
    if (const std::optional<double> value = parse_number(part)) numbers.push_back(*value);
  if (numbers.size() != 4 || split(text, ',').size() != 4)
    return usage_error(where, fmt::format("'{}' is not four numbers", text),
                       "say x,y,dx,dy, as 1,2,22,10");
  return Ray{{numbers[0], numbers[1]}, {numbers[2], numbers[3]}};
}

Result<Override> parse_override(const std::string& text, const Place& where) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    return usage_error(where, fmt::format("'{}' is not key=value", text),
                       "as -D film.background='\"#000000\"'");
  Override made{text.substr(0, equals), text.substr(equals + 1), {}};
  if (where && where.source->name() != "--define") made.where = where;  // else it is shown as -D
  return made;
}

}  // namespace flatray
