#include <algorithm>

#include "base/parallel.h"
#include "image/band_rows.h"
#include "image/checksums.h"
#include "image/deflate.h"
#include "image/png.h"
#include "image/png_chunks.h"

namespace flatray::own_encoder {
namespace {

using Packed = std::vector<std::byte>;

void put_bytes(Packed& out, std::initializer_list<unsigned> values) {
  for (const unsigned value : values) out.push_back(static_cast<std::byte>(value));
}

// Packs bands one after another; its room is kept from one to the next.
class BandPacker {
 public:
  explicit BandPacker(const Image& image)
      : image_(image),
        pixel_(static_cast<std::size_t>(image.channels)),
        row_bytes_(static_cast<std::size_t>(image.width) * pixel_) {}

  PngBand pack(int y) {
    filter(y, std::min(y + band_rows(image_.width), image_.height));
    PngBand band{{}, adler32(filtered_), filtered_.size()};
    PngChunk chunk(band.chunk, "IDAT");
    deflater_.pack(filtered_, pixel_, band.chunk);
    chunk.end();
    return band;
  }

 private:
  // The first row as differences to the pixel on its left, so that it needs no row above; the
  // others to the row above: docs/adr/0007-png-writer.md.
  void filter(int begin, int end) {
    constexpr std::uint8_t kLeft = 1, kAbove = 2;
    filtered_.resize(static_cast<std::size_t>(end - begin) * (row_bytes_ + 1));
    std::uint8_t* out = filtered_.data();
    const auto subtract = byte_kernels(active_isa()).subtract;
    for (int y = begin; y < end; ++y) {
      const std::uint8_t* row = image_.at(0, y);
      *out++ = y == begin ? kLeft : kAbove;
      if (y == begin) {
        std::copy_n(row, pixel_, out);
        subtract(out + pixel_, row + pixel_, row, row_bytes_ - pixel_);
      } else {
        subtract(out, row, image_.at(0, y - 1), row_bytes_);
      }
      out += row_bytes_;
    }
  }

  const Image& image_;
  const std::size_t pixel_, row_bytes_;
  std::vector<std::uint8_t> filtered_;
  Deflater deflater_;
};

void put_header(Packed& out, int width, int height, int channels) {
  put_bytes(out, {137, 'P', 'N', 'G', '\r', '\n', 26, '\n'});
  PngChunk header(out, "IHDR");
  put_number(out, static_cast<std::uint32_t>(width));
  put_number(out, static_cast<std::uint32_t>(height));
  put_bytes(out, {8, channels == 3 ? 2U : 6U, 0, 0, 0});
  header.end();
  PngChunk stream(out, "IDAT");
  put_bytes(out, {0x78, 0x01});  // zlib: deflate with a window of 32 kB
  stream.end();
}

void put_end(Packed& out, std::uint32_t adler) {
  PngChunk stream(out, "IDAT");
  put_bytes(out, {0x03, 0x00});  // an empty last block
  put_number(out, adler);
  stream.end();
  PngChunk(out, "IEND").end();
}

std::vector<std::byte> joined(const Image& image, std::span<const PngBand> bands) {
  constexpr std::size_t kFrame = 128;  // what stands around the bands
  std::size_t size = kFrame;
  for (const PngBand& band : bands) size += band.chunk.size();
  Packed out;
  out.reserve(size);
  put_header(out, image.width, image.height, image.channels);
  std::uint32_t adler = 1;
  for (const PngBand& band : bands) {
    out.insert(out.end(), band.chunk.begin(), band.chunk.end());
    adler = joined_adler32(adler, band.adler, band.unpacked_bytes);
  }
  put_end(out, adler);
  return out;
}

Packed encode(const Image& image, unsigned threads, const RowsChanged& changed, PngBands& kept) {
  constexpr std::size_t kBandsATask = 4;  // which share their room
  const int rows = band_rows(image.width);
  const bool alike =
      image.width == kept.width && image.height == kept.height && image.channels == kept.channels;
  kept.width = image.width, kept.height = image.height, kept.channels = image.channels;
  kept.bands.resize(static_cast<std::size_t>((image.height + rows - 1) / rows));
  std::vector<int> tops;  // of what is to pack
  for (int y = 0; y < image.height; y += rows)
    if (!alike || changed(y, std::min(y + rows, image.height))) tops.push_back(y);
  kept.packed += tops.size();
  kept.kept += kept.bands.size() - tops.size();
  parallel_for((tops.size() + kBandsATask - 1) / kBandsATask, threads, [&](std::size_t task) {
    BandPacker packer(image);
    const std::size_t end = std::min(tops.size(), (task + 1) * kBandsATask);
    for (std::size_t i = task * kBandsATask; i < end; ++i)
      kept.bands[static_cast<std::size_t>(tops[i] / rows)] = packer.pack(tops[i]);
  });
  return joined(image, kept.bands);
}

}  // namespace

extern const PngWriter entry = {
    "own", "in bands packed side by side, and kept where nothing changed; same bytes everywhere",
    &encode};

}  // namespace flatray::own_encoder
