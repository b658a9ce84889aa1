// Goal S11: PNG of a 1080p frame against stb_image_write's default, flat, smoothed and noisy.
#include <fmt/core.h>

#include <cstring>

#include "base/philox.h"
#include "drawing.h"
#include "image/png.h"
#include "measure.h"

#define STBI_ONLY_PNG
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#include <stb_image.h>
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>

namespace {

using flatray::Image;
using Bytes = std::vector<std::byte>;

constexpr int kWidth = 1920, kHeight = 1080;

Image drawn(flatray::Coverage coverage) {
  const auto polygons = bench::polygons(1000, kWidth, kHeight);
  return flatray::render_image(bench::draw_list(polygons, kWidth, kHeight, coverage), {});
}

// Light of a lamp by few rays: bright in the middle, no two pixels alike.
Image noisy() {
  Image image(kWidth, kHeight, 3);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const double dx = x - kWidth / 2.0, dy = y - kHeight / 2.0;
      const double light = 60 + 120 / (1 + (dx * dx + dy * dy) * 1e-5);
      const auto bits = flatray::random_bits(2, flatray::Stream::experiment, 0,
                                             static_cast<unsigned>(y * kWidth + x));
      for (int c = 0; c < 3; ++c) {
        const double noise = static_cast<double>((bits >> (16 * c)) & 0xffff) / 65536 - 0.5;
        image.at(x, y)[c] = static_cast<std::uint8_t>(light + 60 * noise);
      }
    }
  return image;
}

// A smooth wave in all channels: no flat part, no noise.
Image gradient() {
  Image image(kWidth, kHeight, 3);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      for (int c = 0; c < 3; ++c)
        image.at(x, y)[c] =
            static_cast<std::uint8_t>(127.5 + 127 * std::sin(0.004 * (x + c * 100) + 0.007 * y));
  return image;
}

Bytes by_stb(const Image& image) {
  Bytes bytes;
  const auto append = [](void* all, void* data, int size) {
    const auto* from = static_cast<const std::byte*>(data);
    static_cast<Bytes*>(all)->insert(static_cast<Bytes*>(all)->end(), from, from + size);
  };
  stbi_write_png_to_func(append, &bytes, image.width, image.height, image.channels,
                         image.pixels.data(), image.width * image.channels);
  return bytes;
}

bool decodes_to(const Bytes& bytes, const Image& image) {
  int width = 0, height = 0, channels = 0;
  auto* pixels = stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()),
                                       static_cast<int>(bytes.size()), &width, &height, &channels,
                                       image.channels);
  const bool same = pixels != nullptr && width == image.width && height == image.height &&
                    std::memcmp(pixels, image.pixels.data(), image.pixels.size()) == 0;
  stbi_image_free(pixels);
  return same;
}

bool row(const char* name, const Image& image, const char* must, const char* aim) {
  const Bytes ours = flatray::encode_png(image), theirs = by_stb(image);
  if (!decodes_to(ours, image) || !decodes_to(theirs, image)) {
    fmt::print("{}: a PNG does not decode to its picture\n", name);
    return false;
  }
  const std::vector<double> times =
      bench::compare({{"flatray", [&] { (void)flatray::encode_png(image); }},
                      {"stb_image_write", [&] { (void)by_stb(image); }}},
                     9);
  fmt::print("| {:9} | {:7.2f} | {:7.1f} | {:5.1f} | {:4} | {:3} | {:5} | {:5} |\n", name,
             1e3 * times[0], 1e3 * times[1], times[1] / times[0], must, aim, ours.size() / 1000,
             theirs.size() / 1000);
  return true;
}

}  // namespace

int main() {
  fmt::print(
      "S11: PNG of {} x {} RGB, one thread, ms of CPU time, medians of 9 rounds in turn\n"
      "| picture   | flatray |     stb | ratio | must | aim |   kB | stb kB |\n"
      "|---|---|---|---|---|---|---|---|\n",
      kWidth, kHeight);
  const bool all = row("flat", drawn(flatray::Coverage::centre), "2", "13") &&
                   row("smoothed", drawn(flatray::Coverage::area), "3.5", "19") &&
                   row("noisy", noisy(), "5.5", "40") && row("gradient", gradient(), "-", "-");
  return all ? 0 : 1;
}
