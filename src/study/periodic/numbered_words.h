#pragma once
#include <span>
#include <utility>

#include "study/periodic/mirrors.h"

namespace flatray {

/// Words of so many bounces off discs, none of which follows itself, by number in ascending order,
/// and which follows which.
class NumberedWords {
 public:
  NumberedWords(std::size_t discs, std::size_t bounces) : discs_(discs), bounces_(bounces) {
    for (std::size_t k = 1; k < bounces; ++k) tails_ = std::exchange(rests_, rests_ * ways_on());
  }
  /// Bounces of words of which there are no more than so many; 64 at most.
  static std::size_t most_bounces(std::size_t discs, std::size_t most_words) {
    constexpr std::size_t kMostBounces = 64;
    std::size_t bounces = 2, count = discs * (discs - 1);
    while (bounces < kMostBounces && count * (discs - 1) <= most_words) {
      count *= discs - 1;
      ++bounces;
    }
    return bounces;
  }

  /// Those without their last bounce.
  std::size_t starts() const { return discs_ * tails_; }
  std::size_t ways_on() const { return discs_ - 1; }
  std::size_t size() const { return discs_ * rests_; }
  std::size_t bounces() const { return bounces_; }
  /// The word without its first bounce.
  std::size_t end_of(std::size_t word) const {
    const std::size_t rest = word % rests_;
    return next(word / rests_, rest / tails_) * tails_ + rest % tails_;
  }
  Word operator[](std::size_t number) const {
    Word word(bounces_);
    std::size_t part = rests_;
    word[0] = static_cast<std::uint8_t>(number / part);
    for (std::size_t k = 1; k < bounces_; ++k) {
      number %= part;
      part /= ways_on();
      word[k] = static_cast<std::uint8_t>(next(word[k - 1], number / part));
    }
    return word;
  }
  std::size_t number_of(std::span<const std::uint8_t> word) const {
    std::size_t number = word[0];
    for (std::size_t k = 1; k < bounces_; ++k)
      number = number * ways_on() + (word[k] < word[k - 1] ? word[k] : word[k] - 1U);
    return number;
  }

 private:
  // The disc that comes in such a place among those that may follow one.
  static std::size_t next(std::size_t disc, std::size_t place) {
    return place < disc ? place : place + 1;
  }

  std::size_t discs_, bounces_;
  std::size_t rests_ = 1, tails_ = 1;  // ways to go on from the first bounce, and from the second
};

}  // namespace flatray
