#include "image/png_chunks.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "image/checksums.h"
#include "image/png.h"

namespace flatray {
namespace {

using Bytes = std::span<const std::byte>;

constexpr std::size_t kChunkFrame = 12;  // length, type, checksum

std::uint32_t number_at(Bytes bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i)
    number = number << 8 | std::to_integer<std::uint32_t>(bytes[at + i]);
  return number;
}

struct Chunk {
  std::string type;
  Bytes data;
};

// Takes chunks off the front, each only when whole and with its checksum right.
class ChunkReader {
 public:
  ChunkReader(Bytes bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  bool starts_as_png() {
    const std::string_view text(reinterpret_cast<const char*>(bytes_.data()), bytes_.size());
    const bool same = text.starts_with(kPngSignature);
    at_ = same ? kPngSignature.size() : 0;
    return same;
  }

  Result<Chunk> next() {
    begin_ = at_;
    const std::size_t left = bytes_.size() - at_;
    if (left < kChunkFrame || number_at(bytes_, at_) > left - kChunkFrame)
      return wrong("PNG ends in the middle", "the file is cut short: write or copy it again");
    const std::size_t length = number_at(bytes_, at_);
    const Bytes checked = bytes_.subspan(at_ + 4, length + 4);
    if (crc32(checked) != number_at(bytes_, at_ + 8 + length))
      return wrong("PNG chunk has a wrong checksum", "the file is damaged: write or copy it again");
    Chunk chunk{{}, checked.subspan(4)};
    for (const std::byte b : checked.first(4)) chunk.type += std::to_integer<char>(b);
    at_ += kChunkFrame + length;
    return chunk;
  }

  // Where in the file the data of the chunk last taken begin.
  std::size_t data_at() const { return begin_ + 8; }

  bool at_end() const { return at_ == bytes_.size(); }

  // Of the chunk last taken, or of the one that cannot be.
  tl::unexpected<Diagnostics> wrong(const std::string& what, std::string hint) const {
    return fail(named_place(name_), fmt::format("{} (at byte {})", what, begin_), std::move(hint));
  }

 private:
  Bytes bytes_;
  const std::string& name_;
  std::size_t begin_ = 0, at_ = 0;
};

int channels(int colour_type) {
  constexpr std::array<int, 7> kChannels = {1, 0, 3, 1, 2, 0, 4};
  return colour_type < 7 ? kChannels[static_cast<std::size_t>(colour_type)] : 0;
}

bool depth_fits(int depth, int colour_type) {
  const bool power_of_two = depth > 0 && depth <= 16 && (depth & (depth - 1)) == 0;
  if (colour_type == 0) return power_of_two;
  return colour_type == 3 ? power_of_two && depth <= 8 : depth == 8 || depth == 16;
}

Result<PngHeader> header(const ChunkReader& reader, const Chunk& chunk, std::uint64_t max_pixels) {
  if (chunk.type != "IHDR" || chunk.data.size() != 13)
    return reader.wrong("PNG does not begin with its header", "it is not a PNG any program writes");
  const auto field = [&](std::size_t i) { return std::to_integer<int>(chunk.data[i]); };
  PngHeader png;
  png.width = number_at(chunk.data, 0), png.height = number_at(chunk.data, 4);
  png.bit_depth = field(8), png.colour_type = field(9), png.interlaced = field(12) == 1;
  png.alpha = png.colour_type == 4 || png.colour_type == 6;
  const bool known = channels(png.colour_type) != 0 && depth_fits(png.bit_depth, png.colour_type) &&
                     field(10) == 0 && field(11) == 0 && field(12) <= 1;
  if (!known || png.width == 0 || png.height == 0)
    return reader.wrong("PNG header has impossible values", "it is not a PNG any program writes");
  if (std::uint64_t{png.width} * png.height > max_pixels)
    return reader.wrong(
        fmt::format("picture of {} x {} pixels is too large", png.width, png.height),
        fmt::format("at most {} pixels are read", max_pixels));
  if (png.bit_depth == 16)
    return reader.wrong("PNG has 16 bits a channel", "8 bits a channel are read: convert it");
  return png;
}

bool is_critical(const std::string& type) { return (type[0] & 0x20) == 0; }

std::uint64_t pass_bytes(std::uint64_t width, std::uint64_t height, std::uint64_t bits_a_pixel) {
  return width == 0 ? 0 : height * (1 + (width * bits_a_pixel + 7) / 8);
}

}  // namespace

std::uint64_t PngHeader::unpacked_bytes() const {
  const auto bits =
      static_cast<std::uint64_t>(channels(colour_type)) * static_cast<std::uint64_t>(bit_depth);
  if (!interlaced) return pass_bytes(width, height, bits);
  struct Pass {
    std::uint32_t x, y, step_x, step_y;
  };
  constexpr Pass kAdam7[] = {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4},
                             {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}};
  std::uint64_t total = 0;
  for (const auto& [x, y, step_x, step_y] : kAdam7)
    total += pass_bytes((std::uint64_t{width} + step_x - 1 - x) / step_x,
                        (std::uint64_t{height} + step_y - 1 - y) / step_y, bits);
  return total;
}

void put_number(std::vector<std::byte>& out, std::uint32_t number) {
  for (const unsigned shift : {24U, 16U, 8U, 0U})
    out.push_back(static_cast<std::byte>(number >> shift));
}

PngChunk::PngChunk(std::vector<std::byte>& out, std::string_view type)
    : out_(out), begin_(out.size()) {
  put_number(out, 0);
  for (const char c : type) out.push_back(static_cast<std::byte>(c));
}

void PngChunk::end() {
  std::vector<std::byte> length;
  put_number(length, static_cast<std::uint32_t>(out_.size() - begin_ - 8));
  std::copy(length.begin(), length.end(), out_.begin() + static_cast<std::ptrdiff_t>(begin_));
  put_number(out_, crc32(std::span(out_).subspan(begin_ + 4)));
}

Result<PngHeader> read_png_chunks(std::span<const std::byte> bytes, const std::string& name,
                                  std::uint64_t max_pixels) {
  ChunkReader reader(bytes, name);
  if (!reader.starts_as_png())
    return reader.wrong("is not a PNG",
                        "pictures are read as PNG, and light by the names .hdr and .pfm");
  FLATRAY_TRY(chunk, reader.next());
  Result<PngHeader> png = header(reader, *chunk, max_pixels);
  std::string before;
  while (png && chunk->type != "IEND") {
    before = chunk->type;
    chunk = reader.next();
    if (!chunk) return fail(std::move(chunk));
    const std::string& type = chunk->type;
    if (type == "IDAT") {
      if (before != "IDAT" && !png->deflated.empty())
        return reader.wrong("PNG has pixels in two places", "it is not a PNG any program writes");
      const auto* packed = reinterpret_cast<const char*>(chunk->data.data());
      png->deflated.insert(png->deflated.end(), packed, packed + chunk->data.size());
    } else if (type == "PLTE") {
      png->palette_at = reader.data_at(), png->palette_size = chunk->data.size();
      if (png->palette_size % 3 != 0)
        return reader.wrong("PNG palette ends within a colour",
                            "it is not a PNG any program writes");
    } else if (type == "tRNS") {
      png->alpha = true;
    } else if (type == "acTL" && chunk->data.size() == 8) {
      png->frames = number_at(chunk->data, 0);
    } else if (is_critical(type) && type != "IEND") {
      return reader.wrong("PNG needs what is not known here", "save it as a plain PNG");
    }
  }
  if (png && !reader.at_end())
    return reader.wrong("PNG goes on after its end", "the file is damaged: write it again");
  return png;
}

}  // namespace flatray
