#pragma once
#include <cstdint>
#include <span>

#include "base/isa.h"
#include "image/kernels/byte_kernels.h"

namespace flatray {

const kernels::ByteKernels& byte_kernels(Isa isa);

/// CRC-32 of PNG chunks (ISO/IEC 15948, 5.5), of bytes after others whose CRC is `before`.
std::uint32_t crc32(std::span<const std::byte> bytes, std::uint32_t before = 0);

/// Adler-32 of zlib streams (RFC 1950), likewise.
std::uint32_t adler32(std::span<const std::uint8_t> bytes, std::uint32_t before = 1);
/// Adler-32 of two parts, from that of each; the second has `size` bytes.
std::uint32_t joined_adler32(std::uint32_t first, std::uint32_t second, std::uint64_t size);

}  // namespace flatray
