#include "image/checksums.h"

#include <gtest/gtest.h>

#include "base/philox.h"

namespace flatray {
namespace {

using Octets = std::vector<std::uint8_t>;

Octets random_bytes(std::size_t count) {
  Octets bytes(count);
  for (std::size_t i = 0; i < count; ++i)
    bytes[i] = static_cast<std::uint8_t>(random_bits(5, Stream::test, 0, i));
  return bytes;
}

std::span<const std::byte> raw(std::span<const std::uint8_t> bytes) { return std::as_bytes(bytes); }

Octets bytes_of(std::string_view text) { return {text.begin(), text.end()}; }

// The remainder of the message, bit by bit.
std::uint32_t crc_by_definition(const Octets& bytes) {
  std::uint32_t crc = ~0U;
  for (const std::uint8_t byte : bytes) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) * 0xedb88320U);
  }
  return ~crc;
}

std::uint32_t adler_by_definition(const Octets& bytes) {
  std::uint64_t a = 1, b = 0;
  for (const std::uint8_t byte : bytes) a = (a + byte) % 65521, b = (b + a) % 65521;
  return static_cast<std::uint32_t>(b << 16 | a);
}

TEST(Checksums, HaveTheirPublishedCheckValues) {
  EXPECT_EQ(crc32(raw(bytes_of("123456789"))), 0xcbf43926U);
  EXPECT_EQ(adler32(bytes_of("123456789")), 0x091e01deU);
  EXPECT_EQ(crc32({}), 0U);
  EXPECT_EQ(adler32({}), 1U);
}

TEST(Checksums, EqualTheirDefinitionsAtEveryLength) {
  for (std::size_t count = 0; count < 400; ++count) {
    const Octets bytes = random_bytes(count);
    ASSERT_EQ(crc32(raw(bytes)), crc_by_definition(bytes)) << count;
    ASSERT_EQ(adler32(bytes), adler_by_definition(bytes)) << count;
  }
}

TEST(Checksums, OfPartsJoinToThatOfTheWhole) {
  const Octets bytes = random_bytes(5000);
  const std::span<const std::uint8_t> all(bytes);
  for (const std::size_t cut : {0U, 1U, 63U, 64U, 2500U, 4999U, 5000U}) {
    const auto first = all.first(cut), second = all.subspan(cut);
    EXPECT_EQ(crc32(raw(second), crc32(raw(first))), crc32(raw(all))) << cut;
    EXPECT_EQ(adler32(second, adler32(first)), adler32(all)) << cut;
    EXPECT_EQ(joined_adler32(adler32(first), adler32(second), second.size()), adler32(all)) << cut;
  }
}

TEST(Checksums, EveryTierGivesTheSame) {
  for (const Octets& bytes : {random_bytes(100'003), Octets(100'003, 255)}) {
    const std::uint32_t adler = adler_by_definition(bytes), crc = crc_by_definition(bytes);
    for (const Isa isa : available_isas()) {
      const kernels::AdlerSums sums = byte_kernels(isa).adler({1, 0}, bytes.data(), bytes.size());
      EXPECT_EQ(sums.b << 16 | sums.a, adler) << isa_name(isa);
      const auto fold = byte_kernels(isa).fold_crc;
      if (fold == nullptr) continue;
      Octets folded(16);
      fold(~0U, bytes.data(), bytes.size() / 64, folded.data());
      folded.insert(folded.end(), bytes.end() - static_cast<std::ptrdiff_t>(bytes.size() % 64),
                    bytes.end());
      EXPECT_EQ(crc32(raw(folded), ~0U), crc) << isa_name(isa);
    }
  }
}

TEST(RowDifference, IsTheSameInEveryTierAtEveryLength) {
  const Octets a = random_bytes(300), b(a.rbegin(), a.rend());
  for (const Isa isa : available_isas())
    for (std::size_t count = 0; count <= a.size(); ++count) {
      Octets out(count + 1, 77);
      byte_kernels(isa).subtract(out.data(), a.data(), b.data(), count);
      for (std::size_t i = 0; i < count; ++i)
        ASSERT_EQ(out[i], static_cast<std::uint8_t>(a[i] - b[i])) << isa_name(isa) << ' ' << count;
      ASSERT_EQ(out[count], 77);
    }
}

}  // namespace
}  // namespace flatray
