// Segments that the kernels cannot tell apart, and those that nothing tells apart.
#include <bit>

#include "trace/cells.h"
#include "trace/cells_hashes.h"

namespace flatray {
namespace {

constexpr std::uint64_t kFirst = 0x9e3779b97f4a7c15U, kSecond = 0xbf58476d1ce4e5b9U;

std::uint64_t hash_of(const CellGrid::Mark& m) {
  // + 0: -0 and 0 are equal to the kernels.
  const auto word = [](float x) -> std::uint64_t { return std::bit_cast<std::uint32_t>(x + 0); };
  const std::uint64_t hash = (word(m.ax) << 32 | word(m.ay)) * kFirst;
  return ((hash ^ hash >> 29) + word(m.bx)) * kSecond;
}

// The same for a segment from either of its ends.
std::uint64_t hash_of(const Segment& segment) {
  const auto word = [](double x) { return std::bit_cast<std::uint64_t>(x + 0); };
  const auto end = [&](const Vec2& p) {
    const std::uint64_t hash = (word(p.x()) ^ word(p.x()) >> 32) * kFirst;
    return ((hash ^ hash >> 29) + word(p.y())) * kSecond;
  };
  const std::uint64_t sum = end(segment.a) + end(segment.b);
  return (sum ^ sum >> 31) * kFirst;
}

bool are_copies(const Segment& one, const Segment& other) {
  return (one.a == other.a && one.b == other.b) || (one.a == other.b && one.b == other.a);
}

}  // namespace

// That two marks share a hash is as good as that they are equal.
void CellGrid::find_twins(const Surfaces& walls, unsigned threads) {
  const std::size_t count = walls.segments.size();
  const HashShares marks(count, threads,
                         [&](std::size_t slot) { return hash_of(mark(walls.segments[slot])); });
  for (const auto& [one, other] :
       marks.pairs(threads, [](std::uint32_t, std::uint32_t) { return true; })) {
    twins_.resize(count);
    twins_[one] = twins_[other] = true;
  }
}

void CellGrid::find_copies(const Surfaces& walls, unsigned threads) {
  const std::size_t count = walls.segments.size();
  kept_ = count;
  const HashShares ends(count, threads,
                        [&](std::size_t slot) { return hash_of(walls.segments[slot]); });
  for (const auto& [before, copy] :
       ends.pairs(threads, [&](std::uint32_t one, std::uint32_t other) {
         return are_copies(walls.segments[one], walls.segments[other]);
       })) {
    next_copy_.resize(count, kNoSlot);
    copies_.resize(count);
    next_copy_[before] = copy;
    copies_[copy] = true;
    --kept_;
  }
}

}  // namespace flatray
