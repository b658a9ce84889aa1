#include "render/coverage/bit_runs.h"

#include <gtest/gtest.h>

#include "oracle/families.h"

namespace flatray {
namespace {

using Bits = std::vector<bool>;
using Runs = std::vector<std::pair<int, int>>;

// Three words, of runs short and long and of such that end where a word does.
std::array<std::uint64_t, 3> words_of(std::uint64_t item) {
  oracle::Draw draw(1, 1, item);
  Bits bits(192);
  for (std::size_t at = 0; at < bits.size();) {
    const std::size_t to = std::min<std::size_t>(
        bits.size(), draw.unit() < 0.2 ? (at / 64 + 1) * 64
                                       : at + 1 + static_cast<std::size_t>(draw.whole(0, 70)));
    const bool on = draw.unit() < 0.5;
    for (; at < to; ++at) bits[at] = on;
  }
  std::array<std::uint64_t, 3> words{};
  for (std::size_t at = 0; at < bits.size(); ++at)
    words[at / 64] |= std::uint64_t{bits[at]} << (at % 64);
  return words;
}

bool is_set(std::span<const std::uint64_t> words, int at) {
  return at >= 0 && at < 192 && (words[static_cast<std::size_t>(at) / 64] >> (at % 64) & 1) != 0;
}

TEST(BitRuns, AreTheLongestStretchesOfOnesFromLeftToRight) {
  for (std::uint64_t item = 0; item < 500; ++item) {
    const auto words = words_of(item);
    Runs expected, found;
    for (int at = 0; at < 192; ++at) {
      if (!is_set(words, at)) continue;
      if (!is_set(words, at - 1)) expected.emplace_back(at, at);
      expected.back().second = at + 1;
    }
    each_run(
        0, 2, [&](std::size_t i) { return words[i]; },
        [&](int begin, int end) { found.emplace_back(begin, end); });
    ASSERT_EQ(found, expected) << item;
  }
}

TEST(BitRuns, EachOneIsTakenOnceAndThoseWithinAStretchAreItsPlaces) {
  for (std::size_t begin = 0; begin < 192; begin += 5)
    for (std::size_t end = begin + 1; end <= 192; end += 3) {
      std::vector<std::size_t> expected, found;
      for (std::size_t at = begin; at < end; ++at) expected.push_back(at);
      for (std::size_t i = begin / 64; i <= (end - 1) / 64; ++i)
        each_one(i, bits_within(i, begin, end),
                 [&](int at) { found.push_back(static_cast<std::size_t>(at)); });
      ASSERT_EQ(found, expected) << begin << " to " << end;
    }
}

}  // namespace
}  // namespace flatray
