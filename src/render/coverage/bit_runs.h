#pragma once
#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

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

/// Things of a row by the columns they stand in.
class ColumnLists {
 public:
  /// Calls take(numbers) for each column of [left, left + width) with things in it, from left to
  /// right: these by their numbers, rising.
  /// Cost    O(things + width / 64).
  template <class Thing, class Take>
  void each(const std::vector<Thing>& things, int left, int width, const Take& take) {
    first_.resize(static_cast<std::size_t>(width));
    bits_.resize((first_.size() + 63) / 64);
    next_.resize(std::max(next_.size(), things.size()));
    std::size_t begin = bits_.size(), end = 0;
    for (std::size_t i = things.size(); i-- > 0;) {
      const auto place = static_cast<std::size_t>(things[i].column - left), word = place / 64;
      const std::uint64_t bit = std::uint64_t{1} << (place % 64);
      next_[i] = (bits_[word] & bit) != 0 ? first_[place] : kNone;
      bits_[word] |= bit;
      first_[place] = static_cast<std::uint32_t>(i);
      begin = std::min(begin, word), end = std::max(end, word + 1);
    }
    for (std::size_t word = begin; word < end; ++word)
      for (std::uint64_t bits = std::exchange(bits_[word], 0); bits != 0; bits &= bits - 1) {
        numbers_.clear();
        std::uint32_t i = first_[64 * word + static_cast<std::size_t>(std::countr_zero(bits))];
        for (; i != kNone; i = next_[i]) numbers_.push_back(i);
        take(std::span<const std::uint32_t>(numbers_));
      }
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffffU;
  std::vector<std::uint64_t> bits_;  ///< of columns with things
  std::vector<std::uint32_t> first_, next_, numbers_;
};

}  // namespace flatray
