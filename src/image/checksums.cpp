#include "image/checksums.h"

#include <array>

namespace flatray {
namespace {

// Row k: the remainders of a byte followed by k bytes of zero.
using CrcTables = std::array<std::array<std::uint32_t, 256>, 8>;

constexpr CrcTables crc_tables() {
  CrcTables tables{};
  for (std::uint32_t i = 0; i < 256; ++i) {
    std::uint32_t crc = i;
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? 0xedb88320U ^ (crc >> 1) : crc >> 1;
    tables[0][i] = crc;
  }
  for (std::size_t k = 1; k < tables.size(); ++k)
    for (std::size_t i = 0; i < 256; ++i) {
      const std::uint32_t before = tables[k - 1][i];
      tables[k][i] = tables[0][before & 0xff] ^ (before >> 8);
    }
  return tables;
}

constexpr CrcTables kTables = crc_tables();

std::uint32_t next_crc(std::uint32_t crc, const std::uint8_t* bytes, std::size_t count) {
  for (; count >= 8; count -= 8, bytes += 8) {
    for (std::size_t i = 0; i < 4; ++i) crc ^= static_cast<std::uint32_t>(bytes[i]) << (8 * i);
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < 4; ++i)
      next ^= kTables[7 - i][(crc >> (8 * i)) & 0xff] ^ kTables[3 - i][bytes[4 + i]];
    crc = next;
  }
  for (; count > 0; --count, ++bytes) crc = kTables[0][(crc ^ *bytes) & 0xff] ^ (crc >> 8);
  return crc;
}

}  // namespace

const kernels::ByteKernels& byte_kernels(Isa isa) {
  static constexpr const kernels::ByteKernels* kTiers[] = {
    &kernels::portable_bytes,
#if defined(__x86_64__)
    &kernels::baseline_bytes,
    &kernels::avx2_bytes,
    &kernels::avx512_bytes
#endif
  };
  return *of_tier(kTiers, isa);
}

std::uint32_t crc32(std::span<const std::byte> bytes, std::uint32_t before) {
  constexpr std::size_t kBlock = 64;
  const auto* at = reinterpret_cast<const std::uint8_t*>(bytes.data());
  const std::size_t blocks = bytes.size() / kBlock;
  const auto fold = byte_kernels(active_isa()).fold_crc;
  if (fold == nullptr || blocks == 0) return ~next_crc(~before, at, bytes.size());
  std::array<std::uint8_t, 16> folded{};
  fold(~before, at, blocks, folded.data());
  const std::uint32_t crc = next_crc(0, folded.data(), folded.size());
  return ~next_crc(crc, at + blocks * kBlock, bytes.size() % kBlock);
}

std::uint32_t adler32(std::span<const std::uint8_t> bytes, std::uint32_t before) {
  const kernels::AdlerSums sums =
      byte_kernels(active_isa()).adler({before & 0xffff, before >> 16}, bytes.data(), bytes.size());
  return sums.b << 16 | sums.a;
}

std::uint32_t joined_adler32(std::uint32_t first, std::uint32_t second, std::uint64_t size) {
  constexpr std::uint64_t kModulus = kernels::kAdlerModulus;
  const std::uint64_t before = (first & 0xffff) + kModulus - 1;  // what all of `second` starts on
  const std::uint64_t a = (before + (second & 0xffff)) % kModulus;
  const std::uint64_t b = ((first >> 16) + (second >> 16) + size % kModulus * before) % kModulus;
  return static_cast<std::uint32_t>(b << 16 | a);
}

}  // namespace flatray
