// Segments that the kernels cannot tell apart, and those that nothing tells apart.
#include <bit>

#include "trace/cells.h"
#include "trace/cells_hashes.h"

namespace flatray {
namespace {

// Odd, so that no two words have one product.
constexpr std::uint64_t kSpread = 0x9e3779b97f4a7c15U, kSpreadAgain = 0xbf58476d1ce4e5b9U,
                        kSpreadEnd = 0x94d049bb133111ebU;

std::uint64_t hash_of(const CellGrid::Mark& m) {
  // + 0: -0 and 0 are equal to the kernels.
  const auto word = [](float x) -> std::uint64_t { return std::bit_cast<std::uint32_t>(x + 0); };
  const std::uint64_t hash = (word(m.ax) << 32 | word(m.ay)) * kSpread;
  return ((hash ^ hash >> 29) + word(m.bx)) * kSpreadAgain;
}

std::uint64_t hash_of(const Vec2& end) {
  const auto word = [](double x) { return std::bit_cast<std::uint64_t>(x + 0); };
  std::uint64_t hash = (word(end.x()) ^ word(end.x()) >> 32) * kSpread;
  hash = ((hash ^ hash >> 29) + word(end.y())) * kSpreadAgain;
  hash ^= hash >> 32;
  hash *= kSpreadEnd;
  return hash ^ hash >> 29;
}

bool are_copies(const Segment& one, const Segment& other) {
  return (one.a == other.a && one.b == other.b) || (one.a == other.b && one.b == other.a);
}

}  // namespace

std::uint64_t hash_of_ends(const Segment& segment) {
  const std::uint64_t sum = hash_of(segment.a) + hash_of(segment.b);
  return (sum ^ sum >> 31) * kSpread;
}

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
                        [&](std::size_t slot) { return hash_of_ends(walls.segments[slot]); });
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
