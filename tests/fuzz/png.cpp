// The bytes as they are, and with every chunk's checksum put right: else no change of a seed gets past them.
#include "image/png.h"

#include "fuzz/target.h"

namespace {

using Bytes = std::vector<std::byte>;

constexpr std::size_t kSignatureBytes = 8;
constexpr std::uint64_t kMaxPixels = 1 << 20;

std::uint32_t crc(std::span<const std::byte> bytes) {
  std::uint32_t value = 0xffffffff;
  for (const std::byte b : bytes) {
    value ^= std::to_integer<std::uint32_t>(b);
    for (int bit = 0; bit < 8; ++bit)
      value = (value & 1) != 0 ? 0xedb88320U ^ (value >> 1) : value >> 1;
  }
  return ~value;
}

std::uint32_t number_at(const Bytes& bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i)
    number = number << 8 | std::to_integer<std::uint32_t>(bytes[at + i]);
  return number;
}

void repair_checksums(Bytes& bytes) {
  for (std::size_t at = kSignatureBytes; at + 12 <= bytes.size();) {
    const std::size_t length = number_at(bytes, at);
    if (length > bytes.size() - at - 12) return;
    std::uint32_t sum = crc(std::span(bytes).subspan(at + 4, length + 4));
    for (std::size_t i = 4; i-- > 0; sum >>= 8) bytes[at + 8 + length + i] = std::byte(sum & 0xff);
    at += 12 + length;
  }
}

void decode(const Bytes& bytes) {
  const auto image = flatray::decode_png(bytes, "f.png", kMaxPixels);
  if (!image && flatray::format(image.error()).empty()) std::abort();
  if (!image) return;
  const std::uint64_t pixels =
      static_cast<std::uint64_t>(image->width) * static_cast<std::uint64_t>(image->height);
  if (pixels > kMaxPixels) std::abort();
  const auto again = flatray::decode_png(flatray::encode_png(*image), "f.png", kMaxPixels);
  if (!again || again->pixels != image->pixels) std::abort();
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const flatray::OneSecond limit;
  const auto* first = reinterpret_cast<const std::byte*>(data);
  Bytes bytes(first, first + size);
  decode(bytes);
  repair_checksums(bytes);
  decode(bytes);
  return 0;
}
