#include "geom/outline.h"

#include <algorithm>
#include <array>
#include <bit>

namespace flatray {
namespace {

std::uint64_t bits(double v) { return std::bit_cast<std::uint64_t>(v + 0.0); }  // -0 is 0

bool same(const Vec2& a, const Vec2& b) { return a.x() == b.x() && a.y() == b.y(); }

// The same for both directions of an edge.
std::uint64_t mixed(const Segment& e) {
  const auto point = [](const Vec2& p) {
    std::uint64_t h = bits(p.x()) * 0x9E3779B97F4A7C15U ^ std::rotl(bits(p.y()), 32);
    h = (h ^ (h >> 29)) * 0xBF58476D1CE4E5B9U;
    return h ^ (h >> 32);
  };
  std::uint64_t h = (point(e.a) + point(e.b)) * 0x94D049BB133111EBU;
  return h ^ (h >> 31);
}

constexpr std::uint32_t kNone = ~std::uint32_t{0};
constexpr std::uint32_t kAhead = 64;  // edges whose chains are asked of the memory at once

// Edges still standing, hashed by their ends; those of one line in a chain, the newest first.
class Standing {
 public:
  explicit Standing(std::size_t count)
      : heads_(std::bit_ceil(count + 1), kNone), next_(count, kNone) {}

  // Where an edge's chain begins; the memory is on its way when the caller comes back for it.
  std::size_t chain_of(const Segment& edge) const {
    const std::size_t chain = mixed(edge) & (heads_.size() - 1);
    __builtin_prefetch(&heads_[chain], 1);
    return chain;
  }

  // Takes the newest edge that runs against `edges[index]` out of its chain, or adds the edge to
  // it.
  std::uint32_t cancel_or_add(std::span<const Segment> edges, std::uint32_t index,
                              std::size_t chain) {
    const Segment& edge = edges[index];
    std::uint32_t* link = &heads_[chain];
    std::uint32_t* const head = link;
    for (; *link != kNone; link = &next_[*link]) {
      const Segment& other = edges[*link];
      if (!same(other.a, edge.b) || !same(other.b, edge.a)) continue;
      const std::uint32_t partner = *link;
      *link = next_[partner];
      return partner;
    }
    next_[index] = *head;
    *head = index;
    return kNone;
  }

 private:
  std::vector<std::uint32_t> heads_, next_;
};

}  // namespace

std::vector<std::uint32_t> outline_edges(std::span<const Segment> edges) {
  Standing standing(edges.size());
  const auto count = static_cast<std::uint32_t>(edges.size());
  std::vector<bool> gone(edges.size(), false);
  std::array<std::size_t, kAhead> chains;
  for (std::uint32_t begin = 0; begin < count; begin += kAhead) {
    const std::uint32_t end = std::min(begin + kAhead, count);
    for (std::uint32_t i = begin; i < end; ++i) chains[i - begin] = standing.chain_of(edges[i]);
    for (std::uint32_t i = begin; i < end; ++i) {
      gone[i] = same(edges[i].a, edges[i].b);
      if (gone[i]) continue;
      const std::uint32_t partner = standing.cancel_or_add(edges, i, chains[i - begin]);
      if (partner != kNone) gone[i] = gone[partner] = true;
    }
  }
  std::vector<std::uint32_t> left;
  for (std::uint32_t i = 0; i < count; ++i)
    if (!gone[i]) left.push_back(i);
  return left;
}

}  // namespace flatray
