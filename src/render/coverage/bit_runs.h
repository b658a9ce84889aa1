#pragma once
#include <bit>
#include <cstdint>
#include <utility>

namespace flatray {

/// Calls take(begin, end) for the runs of ones in the words [first, last], `word(i)` being one of
/// them: bit b of word i is at 64 i + b.
template <class Word, class Take>
void each_run(std::size_t first, std::size_t last, const Word& word, const Take& take) {
  int begin = -1;  // of a run that goes on
  for (std::size_t i = first; i <= last; ++i) {
    const int from = static_cast<int>(64 * i);
    std::uint64_t bits = word(i);
    if (begin >= 0) {
      const int ones = std::countr_one(bits);
      if (ones == 64) continue;
      take(std::exchange(begin, -1), from + ones);
      bits &= bits + 1;
    }
    while (bits != 0) {
      const int at = std::countr_zero(bits), end = at + std::countr_one(bits >> at);
      if (end == 64) {
        begin = from + at;
        break;
      }
      take(from + at, from + end);
      bits &= ~std::uint64_t{0} << end;
    }
  }
  if (begin >= 0) take(begin, static_cast<int>(64 * (last + 1)));
}

/// Calls take(place) for each one in the bits of word i.
template <class Take>
void each_one(std::size_t i, std::uint64_t bits, const Take& take) {
  for (; bits != 0; bits &= bits - 1) take(static_cast<int>(64 * i) + std::countr_zero(bits));
}

/// Those of the 64 bits of word i that are within [begin, end), which has some in it.
inline std::uint64_t bits_within(std::size_t i, std::size_t begin, std::size_t end) {
  std::uint64_t bits = ~std::uint64_t{0};
  if (i == begin / 64) bits <<= begin % 64;
  if (i == (end - 1) / 64) bits &= ~std::uint64_t{0} >> (63 - (end - 1) % 64);
  return bits;
}

}  // namespace flatray
