#include "base/utf8.h"

#include <gtest/gtest.h>

#include <string>

namespace flatray {
namespace {

// The character of a code point as the definition writes it, without regard to what is allowed.
std::string encoded(unsigned point, unsigned length) {
  if (length == 1) return {static_cast<char>(point)};
  std::string text;
  const unsigned lead = 0xff00U >> length & 0xffU;
  for (unsigned i = length; i-- > 1;) {
    text.insert(text.begin(), static_cast<char>(0x80 | (point & 0x3f)));
    point >>= 6;
  }
  text.insert(text.begin(), static_cast<char>(lead | point));
  return text;
}

unsigned shortest(unsigned point) {
  return point < 0x80 ? 1 : point < 0x800 ? 2 : point < 0x10000 ? 3 : 4;
}

TEST(Utf8, EveryCharacterHasItsShortestFormAlone) {
  for (unsigned point = 0; point < 0x200000; ++point)
    for (unsigned length = shortest(point); length <= 4; ++length) {
      const bool surrogate = point >= 0xd800 && point < 0xe000;
      const bool good = length == shortest(point) && !surrogate && point <= 0x10ffff;
      ASSERT_EQ(utf8_length(encoded(point, length) + "x"), good ? length : 0u)
          << point << " in " << length;
    }
}

TEST(Utf8, ACharacterCutShortIsNone) {
  for (const unsigned point : {0xe9u, 0x20acu, 0x1f600u}) {
    const std::string whole = encoded(point, shortest(point));
    for (std::size_t size = 0; size < whole.size(); ++size) {
      EXPECT_EQ(utf8_length(whole.substr(0, size)), 0u);
      EXPECT_EQ(utf8_prefix("ab" + whole.substr(0, size)), 2u);
      EXPECT_EQ(utf8_prefix(whole + whole.substr(0, size) + "x"),
                whole.size() + (size == 0 ? 1 : 0));
    }
  }
}

TEST(Utf8, ThePrefixEndsAtTheFirstStrayByte) {
  EXPECT_EQ(utf8_prefix(""), 0u);
  EXPECT_EQ(utf8_prefix("plain"), 5u);
  EXPECT_EQ(utf8_prefix("n\xc3\xa9\xffx"), 3u);
  EXPECT_EQ(utf8_prefix("\x80"), 0u);
}

}  // namespace
}  // namespace flatray
