#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/number_text.h"
#include "image/hdr.h"
#include "image/srgb.h"

namespace flatray {
namespace {

using Quad = std::array<std::uint8_t, 4>;  // red, green, blue, exponent

// Takes bytes off the front; `ended` once there are none left.
struct HdrBytes {
  std::span<const std::byte> rest;
  bool ended = false;

  std::uint8_t next() {
    ended = ended || rest.empty();
    if (ended) return 0;
    const auto byte = std::to_integer<std::uint8_t>(rest.front());
    rest = rest.subspan(1);
    return byte;
  }
  std::string line() {
    std::string text;
    for (char c = static_cast<char>(next()); !ended && c != '\n'; c = static_cast<char>(next()))
      text += c;
    return text;
  }
};

// "-Y 48 +X 64": false for another order of rows, or none.
bool read_size(const std::string& line, std::uint64_t& width, std::uint64_t& height) {
  const std::size_t x = line.find(" +X ");
  if (!line.starts_with("-Y ") || x == std::string::npos) return false;
  const auto number = [](std::string_view text, std::uint64_t& value) {
    value = parse_digits<std::uint64_t>(text).value_or(0);
    return value > 0 && value <= std::uint64_t{1} << 30;
  };
  const std::string_view text = line;
  return number(text.substr(3, x - 3), height) && number(text.substr(x + 4), width);
}

// One channel of a row in runs: of n bytes each, or of one byte n - 128 times.
bool read_runs(HdrBytes& bytes, std::vector<Quad>& row, std::size_t channel) {
  for (std::size_t x = 0; x < row.size();) {
    const std::size_t count = bytes.next();
    const bool same = count > 128;
    const std::size_t length = same ? count - 128 : count;
    if (length == 0 || length > row.size() - x || bytes.ended) return false;
    const std::uint8_t first = bytes.next();
    for (std::size_t i = 0; i < length; ++i)
      row[x++][channel] = same || i == 0 ? first : bytes.next();
  }
  return !bytes.ended;
}

// Bytes that no row of so many pixels is told in less than.
std::size_t least_of_row(std::size_t width) {
  return width >= 8 && width < 32768 ? 4 + 8 * ((width + 126) / 127) : 4 * width;
}

bool read_row(HdrBytes& bytes, std::vector<Quad>& row) {
  Quad first{};
  for (std::uint8_t& value : first) value = bytes.next();
  const std::size_t width = first[2] * std::size_t{256} + first[3];
  if (row.size() >= 8 && row.size() < 32768 && first[0] == 2 && first[1] == 2 &&
      width == row.size()) {
    for (std::size_t channel = 0; channel < 4; ++channel)
      if (!read_runs(bytes, row, channel)) return false;
    return true;
  }
  row[0] = first;
  for (std::size_t x = 1; x < row.size() && !bytes.ended; ++x)
    for (std::uint8_t& value : row[x]) value = bytes.next();
  const auto is_run = [](const Quad& p) { return p[0] == 1 && p[1] == 1 && p[2] == 1; };
  return !bytes.ended && std::ranges::none_of(row, is_run);  // of the oldest files
}

}  // namespace

Result<LinearImage> decode_hdr(std::span<const std::byte> file, const std::string& name,
                               std::uint64_t max_pixels) {
  const auto wrong = [&](const std::string& what, const char* hint) {
    return fail(named_place(name), what, hint);
  };
  HdrBytes bytes{file};
  bool rgbe = false;
  double exposure = 1;  // by which light was multiplied
  for (std::string line = bytes.line(); !line.empty(); line = bytes.line()) {
    constexpr std::string_view kExposure = "EXPOSURE=";
    rgbe = rgbe || line == "FORMAT=32-bit_rle_rgbe";
    if (!line.starts_with(kExposure)) continue;
    const std::string text =
        line.substr(std::min(line.find_first_not_of(' ', kExposure.size()), line.size()));
    exposure *= parse_number(text).value_or(0);
    if (!(exposure > 0 && std::isfinite(exposure)))
      return wrong("HDR header has the exposure '" + text + "'", "write a number above 0");
  }
  std::uint64_t width = 0, height = 0;
  if (!rgbe || !read_size(bytes.line(), width, height))
    return wrong("HDR header is not one of RGBE rows from the top", "write it by flatray render");
  if (width * height > max_pixels)
    return wrong(fmt::format("picture of {} x {} pixels is too large", width, height), "");
  LinearImage image{static_cast<int>(width), static_cast<int>(height), {}};
  std::vector<Quad> row;
  for (std::uint64_t y = 0; y < height; ++y) {
    const bool has_room = bytes.rest.size() >= least_of_row(width);
    if (has_room) row.resize(width);
    if (!has_room || !read_row(bytes, row))
      return wrong("HDR ends in the middle or is damaged", "write or copy it again");
    for (const Quad& pixel : row)
      for (std::size_t c = 0; c < 3; ++c)
        image.pixels.push_back(
            pixel[3] == 0 ? 0
                          : static_cast<float>(std::ldexp(pixel[c], pixel[3] - 136) / exposure));
  }
  if (!bytes.rest.empty())
    return wrong(fmt::format("HDR goes on after its last row, by {} bytes", bytes.rest.size()),
                 "write or copy it again");
  return image;
}

Image develop(const LinearImage& light) {
  Image image(light.width, light.height, 3);
  for (std::size_t i = 0; i < light.pixels.size(); ++i)
    image.pixels[i] = srgb_from_linear(light.pixels[i]);
  return image;
}

}  // namespace flatray
