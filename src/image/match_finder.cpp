#include <algorithm>
#include <bit>
#include <cstring>

#include "image/deflate.h"

namespace flatray {
namespace {

constexpr std::size_t kWord = 8;
constexpr std::size_t kFarthest = 32768;
constexpr std::uint32_t kUnseen = ~0U;
// So many places without a match make each step one longer, up to the longest.
constexpr unsigned kPatience = 5;
constexpr unsigned kLongestStep = 16;

std::uint64_t word_at(const std::uint8_t* bytes) {
  std::uint64_t word = 0;
  std::memcpy(&word, bytes, sizeof word);
  return std::endian::native == std::endian::little ? word : __builtin_bswap64(word);
}

std::size_t equal_bytes(std::uint64_t difference) {
  return static_cast<std::size_t>(std::countr_zero(difference)) / 8;
}

// How far `bytes` from `a` and from `b` > a are equal, up to the end.
std::size_t common_length(std::span<const std::uint8_t> bytes, std::size_t a, std::size_t b) {
  const std::uint8_t* at = bytes.data();
  const std::size_t end = bytes.size(), from = b;
  for (; b + 4 * kWord <= end; a += 4 * kWord, b += 4 * kWord) {
    std::uint64_t differences[4], any = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      differences[i] = word_at(at + a + kWord * i) ^ word_at(at + b + kWord * i);
      any |= differences[i];
    }
    if (any == 0) continue;
    std::size_t i = 0;
    while (differences[i] == 0) ++i;
    return b + kWord * i + equal_bytes(differences[i]) - from;
  }
  while (b < end && at[a] == at[b]) ++a, ++b;
  return b - from;
}

// The next six bytes: two pixels.
std::uint64_t six(std::uint64_t word) { return word << 16; }

}  // namespace

const std::vector<Sequence>& MatchFinder::find(std::span<const std::uint8_t> bytes,
                                               std::size_t pixel) {
  sequences_.clear();
  seen_.fill(kUnseen);
  const std::uint8_t* at = bytes.data();
  std::size_t literals_from = 0, place = pixel;
  unsigned misses = 0;
  while (place + kWord <= bytes.size()) {
    const std::uint64_t next = word_at(at + place);
    std::size_t before = place;  // the match repeats what stands `place - before` earlier
    if (next == 0) {
      while (place > literals_from && at[place - 1] == 0) --place;
      if (place == 0 || at[place - 1] != 0) ++place;
      before = place - 1;
    } else if (next == word_at(at + place - pixel)) {
      before = place - pixel;
    } else {
      std::uint32_t& seen = seen_[(six(next) * 0x9e3779b97f4a7c15U) >> (64 - kHashBits)];
      const std::size_t candidate = seen;
      seen = static_cast<std::uint32_t>(place);
      if (candidate == kUnseen || place - candidate > kFarthest ||
          six(word_at(at + candidate) ^ next) != 0) {
        place += std::min(1 + (++misses >> kPatience), kLongestStep);
        continue;
      }
      before = candidate;
    }
    while (next != 0 && place > literals_from && before > 0 && at[place - 1] == at[before - 1])
      --place, --before;
    const std::size_t length = common_length(bytes, before, place);
    sequences_.push_back({static_cast<std::uint32_t>(place - literals_from),
                          static_cast<std::uint32_t>(length),
                          static_cast<std::uint32_t>(place - before)});
    place += length;
    literals_from = place;
    misses = 0;
  }
  sequences_.push_back({static_cast<std::uint32_t>(bytes.size() - literals_from), 0, 0});
  return sequences_;
}

}  // namespace flatray
