#pragma once
#include <cmath>

#include "base/philox.h"

namespace flatray {

/// The numbers below `count` in an order drawn by a seed, any of them at once: nothing is kept.
///
/// Needs   count < 2^52.
/// Cost    four draws a number, of few numbers some more.
/// Source  Feistel, Cryptography and computer privacy, 1973, on numbers of two digits; Black and
///         Rogaway, Ciphers with arbitrary finite domains, 2002, for going on until it is one below.
class Shuffled {
 public:
  Shuffled(std::uint64_t count, std::uint64_t seed, Stream stream)
      : count_(count),
        base_(static_cast<std::uint64_t>(std::ceil(std::sqrt(static_cast<double>(count))))),
        seed_(seed),
        stream_(stream) {}

  std::uint64_t size() const { return count_; }
  /// Needs   i < size().
  std::uint64_t operator[](std::uint64_t i) const {
    do i = mixed(i);
    while (i >= count_);
    return i;
  }

 private:
  // A permutation of all numbers of two digits to this base.
  std::uint64_t mixed(std::uint64_t i) const {
    std::uint64_t high = i / base_, low = i % base_;
    for (std::uint64_t round = 0; round < 4; ++round) {
      const std::uint64_t sum = high + random_bits(seed_, stream_, round, low) % base_;
      high = low;
      low = sum % base_;
    }
    return high * base_ + low;
  }

  std::uint64_t count_, base_;  ///< base^2 >= count
  std::uint64_t seed_;
  Stream stream_;
};

}  // namespace flatray
