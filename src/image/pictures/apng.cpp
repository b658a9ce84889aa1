#include "base/check.h"
#include "image/frame_rate.h"
#include "image/picture_format.h"
#include "image/png_chunks.h"

namespace flatray::apng_format {
namespace {

using Bytes = PictureFormat::Bytes;

constexpr std::uint32_t kMost = 65535;  // of 16 bits
constexpr std::size_t kHeadBytes = 33;  // signature and header of a PNG

void put_16(Bytes& out, std::uint32_t number) {
  out.push_back(static_cast<std::byte>(number >> 8));
  out.push_back(static_cast<std::byte>(number));
}

// The rows as the picture's PNG packs them, under numbers that count the chunks. Who knows no animation
// sees the first frame.
Bytes part(std::span<const std::byte> picture, std::size_t index, const FrameSequence& sequence) {
  const auto png = read_png_chunks(picture, "frame", ~std::uint64_t{0});
  FLATRAY_CHECK(png.has_value());
  const auto number = static_cast<std::uint32_t>(index == 0 ? 0 : 2 * index - 1);
  Bytes out;
  if (index == 0) {
    out.assign(picture.begin(), picture.begin() + kHeadBytes);
    PngChunk animation(out, "acTL");
    put_number(out, static_cast<std::uint32_t>(sequence.frames));
    put_number(out, 0);  // for ever
    animation.end();
  }
  PngChunk control(out, "fcTL");
  for (const std::uint32_t field : {number, png->width, png->height, 0U, 0U})
    put_number(out, field);
  const Ratio rate = nearest_ratio(sequence.fps, kMost);
  put_16(out, rate.under), put_16(out, rate.over);  // seconds that it stays
  put_16(out, 0);  // it stays as it is, and replaces what was there, alpha too
  control.end();
  PngChunk rows(out, index == 0 ? "IDAT" : "fdAT");
  if (index > 0) put_number(out, number + 1);
  const auto packed = std::as_bytes(std::span(png->deflated));
  out.insert(out.end(), packed.begin(), packed.end());
  rows.end();
  if (index + 1 == sequence.frames) PngChunk(out, "IEND").end();
  return out;
}

}  // namespace

extern const PictureFormat entry = {
    .name = "apng",
    .summary = "video as an animated PNG, which browsers show, for ever",
    .kind = "an animated PNG",
    .beginning = kPngSignature,
    .of_picture = [](const Image& image, PngEncoder& encoder,
                     const RowsChanged& changed) { return encoder.encode(image, changed); },
    .part = &part,
    .least_fps = 1.0 / kMost,
    .most_fps = kMost};

}  // namespace flatray::apng_format
