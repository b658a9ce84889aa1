#pragma once
#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace flatray {

/// Which rounds of rays a film has seen, by their numbers from 0.
class FilmRounds {
 public:
  /// Numbers are below this.
  static constexpr std::uint64_t kMost = std::uint64_t{1} << 22;

  FilmRounds() = default;
  /// As `words()` gave them.
  explicit FilmRounds(std::vector<std::uint64_t> words) : words_(std::move(words)) {}

  bool has(std::uint64_t round) const {
    const std::size_t word = round / 64;
    return word < words_.size() && ((words_[word] >> (round % 64)) & 1U) != 0;
  }
  void add(std::uint64_t round) {
    if (words_.size() <= round / 64) words_.resize(round / 64 + 1);
    words_[round / 64] |= std::uint64_t{1} << (round % 64);
  }
  void add(const FilmRounds& more) {
    if (words_.size() < more.words_.size()) words_.resize(more.words_.size());
    for (std::size_t i = 0; i < more.words_.size(); ++i) words_[i] |= more.words_[i];
  }
  bool meets(const FilmRounds& other) const {
    for (std::size_t i = 0; i < std::min(words_.size(), other.words_.size()); ++i)
      if ((words_[i] & other.words_[i]) != 0) return true;
    return false;
  }
  std::uint64_t count() const {
    std::uint64_t count = 0;
    for (const std::uint64_t word : words_)
      count += static_cast<std::uint64_t>(std::popcount(word));
    return count;
  }
  /// 64 rounds a word, the lowest first; the last word is not 0.
  const std::vector<std::uint64_t>& words() const { return words_; }
  bool operator==(const FilmRounds&) const = default;

 private:
  std::vector<std::uint64_t> words_;
};

}  // namespace flatray
