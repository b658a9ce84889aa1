#include <fmt/core.h>

#include <memory>

#include "base/file.h"
#include "image/checksums.h"
#include "image/png.h"
#include "image/png_chunks.h"

#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#define STBI_NO_HDR
#define STBI_NO_FAILURE_STRINGS
#define STBI_MAX_DIMENSIONS (1 << 30)
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#include <stb_image.h>

namespace flatray {
namespace {

// Deflate makes of a byte at most so many.
constexpr std::uint64_t kMostInflation = 1032;

// stb_image lets the packed pixels unpack to any size, and fills what is missing with what lay in
// memory.
bool unpacks_exactly(const PngHeader& png) {
  const std::uint64_t size = png.unpacked_bytes();
  if (size > kMostInflation * png.deflated.size()) return false;
  if (size > kMostPictureBytes || png.deflated.size() > kMostPictureBytes) return false;
  const auto unpacked = std::make_unique_for_overwrite<char[]>(size);
  if (stbi_zlib_decode_buffer(unpacked.get(), static_cast<int>(size), png.deflated.data(),
                              static_cast<int>(png.deflated.size())) != static_cast<int>(size))
    return false;
  std::uint32_t adler = 0;  // which stb_image passes over
  for (std::size_t i = png.deflated.size() - 4; i < png.deflated.size(); ++i)
    adler = adler << 8 | static_cast<std::uint8_t>(png.deflated[i]);
  return adler == adler32({reinterpret_cast<const std::uint8_t*>(unpacked.get()), size});
}

// stb_image takes colours beyond the end of a palette from memory that nothing was written to. Here
// the palette has all that the samples can name, in a copy `whole` where the file's is short; the
// checksums behind it are no longer read.
std::span<const std::byte> with_whole_palette(std::span<const std::byte> bytes,
                                              const PngHeader& png, std::vector<std::byte>& whole) {
  const std::size_t size = 3 * (std::size_t{1} << png.bit_depth);
  if (png.colour_type != 3 || png.palette_size >= size || png.palette_size == 0) return bytes;
  whole.assign(bytes.begin(), bytes.end());
  const auto end = static_cast<std::ptrdiff_t>(png.palette_at + png.palette_size);
  whole.insert(whole.begin() + end, size - png.palette_size, std::byte{0});
  whole[png.palette_at - 6] = static_cast<std::byte>(size >> 8);  // its length, of four bytes
  whole[png.palette_at - 5] = static_cast<std::byte>(size & 0xff);
  return whole;
}

}  // namespace

Result<Image> decode_png(std::span<const std::byte> bytes, const std::string& name,
                         std::uint64_t max_pixels) {
  FLATRAY_TRY(png, read_png_chunks(bytes, name, max_pixels));
  if (png->frames > 1)
    return fail(named_place(name), fmt::format("is an animated PNG of {} frames", png->frames),
                "give pictures of single frames");
  constexpr std::uint32_t kMostSideOfStb = 1 << 24;  // of stb_image
  if (std::max(png->width, png->height) > kMostSideOfStb)
    return fail(named_place(name),
                fmt::format("PNG of {} x {} pixels is not read", png->width, png->height),
                "2^24 are the most in a row or column; write it as PFM");
  const auto damaged = [&] {
    return fail(named_place(name), "PNG pixels cannot be unpacked",
                "the file is damaged: write it again");
  };
  std::vector<std::byte> whole;
  bytes = with_whole_palette(bytes, *png, whole);
  if (!unpacks_exactly(*png) || bytes.size() > kMostPictureBytes) return damaged();
  int width = 0, height = 0, of_file = 0;
  const int channels = png->alpha ? 4 : 3;
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()),
                            static_cast<int>(bytes.size()), &width, &height, &of_file, channels),
      &stbi_image_free);
  if (!pixels) return damaged();
  Image image(width, height, channels);
  std::copy_n(pixels.get(), image.pixels.size(), image.pixels.begin());
  return image;
}

Result<Image> read_png(const std::string& path) {
  Result<std::string> content =
      read_file(path, {.bytes = kMostPictureBytes, .begins = {kPngSignature}});
  if (!content) return fail(std::move(content));
  return decode_png(std::as_bytes(std::span(*content)), path);
}

}  // namespace flatray
