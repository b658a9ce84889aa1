#include "image/pfm.h"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>

namespace flatray {
namespace {

static_assert(std::endian::native == std::endian::little, "floats are written as they lie");

std::string header(int width, int height) {
  return fmt::format("{}{} {}\n-1.0\n", kPfmSignature, width, height);
}

std::string_view as_text(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// Takes digits and the character after them off the front; 0 where there are none.
int take_number(std::string_view& text, char after) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const auto length = static_cast<std::size_t>(end - text.data());
  if (error != std::errc{} || length == text.size() || text[length] != after) return 0;
  text.remove_prefix(length + 1);
  return number;
}

}  // namespace

std::vector<std::byte> encode_pfm(const LinearImage& image) {
  const std::string head = header(image.width, image.height);
  const std::size_t row = 3 * sizeof(float) * static_cast<std::size_t>(image.width);
  std::vector<std::byte> bytes(head.size() + row * static_cast<std::size_t>(image.height));
  std::memcpy(bytes.data(), head.data(), head.size());
  for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y)
    std::memcpy(&bytes[head.size() + y * row],
                &image.pixels[image.pixels.size() - (y + 1) * row / sizeof(float)], row);
  return bytes;
}

Result<LinearImage> decode_pfm(std::span<const std::byte> bytes, const std::string& name) {
  std::string_view text = as_text(bytes);
  text.remove_prefix(std::min(kPfmSignature.size(), text.size()));
  const int width = take_number(text, ' '), height = take_number(text, '\n');
  if (width < 1 || height < 1 || !as_text(bytes).starts_with(header(width, height)))
    return fail(named_place(name), "PFM header is not 'PF', width and height, '-1.0'",
                "colour alone is read, with the lowest byte first; write it by flatray render");
  const std::size_t at = header(width, height).size();
  const std::size_t row = 3 * sizeof(float) * static_cast<std::size_t>(width);
  if ((bytes.size() - at) % row != 0 ||
      (bytes.size() - at) / row != static_cast<std::size_t>(height))
    return fail(
        named_place(name),
        fmt::format("PFM of {} x {} pixels does not have {} bytes", width, height, bytes.size()),
        "write or copy it again");
  LinearImage image{width, height, {}};
  image.pixels.resize((bytes.size() - at) / sizeof(float));
  for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y)
    std::memcpy(&image.pixels[image.pixels.size() - (y + 1) * row / sizeof(float)],
                &bytes[at + y * row], row);
  return image;
}

}  // namespace flatray
