#include "base/hash.h"

#include <gtest/gtest.h>

namespace flatray {
namespace {

std::uint64_t hash_of(std::string_view bytes) {
  return Hash().add(std::as_bytes(std::span(bytes))).value();
}

// Test vectors of the FNV authors (Fowler, Noll, Vo: test_fnv.c, 64-bit FNV-1a).
TEST(Hash, MeetsItsPublishedKnownAnswers) {
  EXPECT_EQ(hash_of(""), 0xcbf29ce484222325U);
  EXPECT_EQ(hash_of("a"), 0xaf63dc4c8601ec8cU);
  EXPECT_EQ(hash_of("foobar"), 0x85944171f73967e8U);
}

TEST(Hash, TheBordersBetweenTextsCount) {
  EXPECT_NE(Hash().add("ab").add("c").value(), Hash().add("a").add("bc").value());
  EXPECT_NE(Hash().add("").value(), Hash().value());
}

TEST(Hash, NumbersAreTheirBytesLowFirst) {
  const std::string bytes("\x08\x07\x06\x05\x04\x03\x02\x01", 8);
  EXPECT_EQ(Hash().add(std::uint64_t{0x0102030405060708}).value(), hash_of(bytes));
}

TEST(Hash, HexIsSixteenLowerCaseDigits) {
  EXPECT_EQ(Hash().hex(), "cbf29ce484222325");
  for (std::uint64_t i = 0; i < 200; ++i) EXPECT_EQ(Hash().add(i).hex().size(), 16U);
}

}  // namespace
}  // namespace flatray
