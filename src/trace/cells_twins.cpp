// Segments that the kernels cannot tell apart.
#include <algorithm>
#include <bit>

#include "base/parallel.h"
#include "trace/cells.h"

namespace flatray {
namespace {

constexpr std::size_t kSegmentsAShare = 16384;  // of one table, which stays in the cache
constexpr std::size_t kMostShares = 16;
constexpr std::size_t kSegmentsAChunk = 65536;

std::uint64_t hash_of(const CellGrid::Mark& m) {
  // + 0: -0 and 0 are equal to the kernels.
  const auto word = [](float x) -> std::uint64_t { return std::bit_cast<std::uint32_t>(x + 0); };
  const std::uint64_t hash = (word(m.ax) << 32 | word(m.ay)) * 0x9e3779b97f4a7c15U;
  return ((hash ^ hash >> 29) + word(m.bx)) * 0xbf58476d1ce4e5b9U | 1;
}

struct Entry {
  std::uint64_t hash = 0;
  std::uint32_t slot = 0;
};
// By chunk of segments and share of hashes.
using Entries = std::vector<std::vector<std::vector<Entry>>>;

// Slots whose hash another has, too.
std::vector<std::uint32_t> twins_of(const Entries& entries, std::size_t share) {
  std::size_t count = 0;
  for (const auto& chunk : entries) count += chunk[share].size();
  const std::size_t room = std::bit_ceil(2 * count + 1);
  std::vector<Entry> table(room);
  std::vector<std::uint32_t> twins;
  for (const auto& chunk : entries)
    for (const Entry& entry : chunk[share]) {
      std::size_t at = entry.hash >> 20 & (room - 1);
      while (table[at].hash != 0 && table[at].hash != entry.hash) at = (at + 1) & (room - 1);
      if (table[at].hash == entry.hash)
        twins.insert(twins.end(), {entry.slot, table[at].slot});
      else
        table[at] = entry;
    }
  return twins;
}

}  // namespace

// That two marks share a hash is as good as that they are equal.
void CellGrid::find_twins(const Surfaces& walls, unsigned threads) {
  const std::size_t count = walls.segments.size();
  const std::size_t shares =
      std::bit_floor(std::clamp<std::size_t>(count / kSegmentsAShare, 1, kMostShares));
  Entries entries((count + kSegmentsAChunk - 1) / kSegmentsAChunk);
  parallel_for(entries.size(), threads, [&](std::size_t chunk) {
    entries[chunk].resize(shares);
    for (auto& share : entries[chunk])
      share.reserve(std::min(count, kSegmentsAChunk) / shares * 9 / 8);
    const std::size_t end = std::min(count, (chunk + 1) * kSegmentsAChunk);
    for (std::size_t slot = chunk * kSegmentsAChunk; slot < end; ++slot) {
      const std::uint64_t hash = hash_of(mark(walls.segments[slot]));
      entries[chunk][hash >> 60 & (shares - 1)].push_back({hash, static_cast<std::uint32_t>(slot)});
    }
  });
  std::vector<std::vector<std::uint32_t>> found(shares);
  parallel_for(shares, threads,
               [&](std::size_t share) { found[share] = twins_of(entries, share); });
  for (const auto& twins : found)
    for (const std::uint32_t slot : twins) {
      twins_.resize(count);
      twins_[slot] = true;
    }
}

}  // namespace flatray
