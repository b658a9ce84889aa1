#pragma once
#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "base/parallel.h"
#include "geom/ray.h"

namespace flatray {

/// The same for a segment from either of its ends, and for -0 and 0. Ends that only add up to the
/// same share none: each is mixed before the two are added.
std::uint64_t hash_of_ends(const Segment& segment);

/// A segment by the hash of what is compared of it, which is not 0.
struct HashedSlot {
  std::uint64_t hash = 0;
  std::uint32_t slot = 0;
};

/// Segments in shares by their hashes, so that equal ones are in one share, by number, and its table
/// stays in the cache.
class HashShares {
 public:
  /// `hash_of(slot)` of all slots below `count`.
  template <class HashOf>
  HashShares(std::size_t count, unsigned threads, const HashOf& hash_of)
      : shares_(std::bit_floor(std::clamp<std::size_t>(count / kSlotsAShare, 1, kMostShares))),
        chunks_((count + kSlotsAChunk - 1) / kSlotsAChunk) {
    parallel_for(chunks_.size(), threads, [&](std::size_t chunk) {
      chunks_[chunk].resize(shares_);
      for (auto& share : chunks_[chunk])
        share.reserve(std::min(count, kSlotsAChunk) / shares_ * 9 / 8);
      const std::size_t end = std::min(count, (chunk + 1) * kSlotsAChunk);
      for (std::size_t slot = chunk * kSlotsAChunk; slot < end; ++slot) {
        const std::uint64_t hash = hash_of(slot) | 1;
        chunks_[chunk][hash >> 60 & (shares_ - 1)].push_back(
            {hash, static_cast<std::uint32_t>(slot)});
      }
    });
  }

  /// Pairs of a slot and the one before it that `same(a, b)` says is the same; those of slots after
  /// each other in no order but within a chain.
  template <class Same>
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs(unsigned threads,
                                                             const Same& same) const {
    std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> found(shares_);
    parallel_for(shares_, threads, [&](std::size_t share) {
      std::size_t count = 0;
      for (const auto& chunk : chunks_) count += chunk[share].size();
      const std::size_t room = std::bit_ceil(2 * count + 1);
      std::vector<HashedSlot> table(room);  // the last of each chain
      for (const auto& chunk : chunks_)
        for (const HashedSlot& each : chunk[share]) {
          std::size_t at = each.hash >> 20 & (room - 1);
          while (table[at].hash != 0 &&
                 !(table[at].hash == each.hash && same(table[at].slot, each.slot)))
            at = (at + 1) & (room - 1);
          if (table[at].hash != 0) found[share].emplace_back(table[at].slot, each.slot);
          table[at] = each;
        }
    });
    std::vector<std::pair<std::uint32_t, std::uint32_t>> all;
    for (const auto& share : found) all.insert(all.end(), share.begin(), share.end());
    return all;
  }

 private:
  static constexpr std::size_t kSlotsAShare = 16384, kMostShares = 16, kSlotsAChunk = 65536;

  std::size_t shares_;
  std::vector<std::vector<std::vector<HashedSlot>>> chunks_;  // by chunk and share
};

}  // namespace flatray
