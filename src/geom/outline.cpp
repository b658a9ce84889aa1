#include "geom/outline.h"

#include <algorithm>
#include <array>
#include <bit>

namespace flatray {
namespace {

std::uint64_t bits(double v) { return std::bit_cast<std::uint64_t>(v + 0.0); }  // -0 is 0

bool same(const Vec2& a, const Vec2& b) { return a.x() == b.x() && a.y() == b.y(); }

struct Ends {
  const Vec2 &a, &b;
};

// The same for both directions of an edge.
std::uint64_t mixed(const Ends& e) {
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

// Edges still standing, hashed by their ends. A chain holds the newest of each line; below it are
// the others of that line, which run the same way.
class Standing {
 public:
  Standing(std::span<const Vec2> points, std::span<const std::uint32_t> to)
      : points_(points),
        to_(to),
        heads_(std::bit_ceil(to.size() + 1), kNone),
        next_(to.size(), kNone) {}

  bool has_length(std::uint32_t edge) const { return !same(ends(edge).a, ends(edge).b); }

  // Where an edge's chain begins; the memory is on its way when the caller comes back for it.
  std::size_t chain_of(std::uint32_t edge) const {
    const std::size_t chain = mixed(ends(edge)) & (heads_.size() - 1);
    __builtin_prefetch(&heads_[chain], 1);
    return chain;
  }

  // Takes the newest edge that runs against this one out of its chain, or adds the edge to it.
  std::uint32_t cancel_or_add(std::uint32_t edge, std::size_t chain) {
    const Ends own = ends(edge);
    std::uint32_t* link = &heads_[chain];
    for (; *link != kNone; link = &next_[*link]) {
      const std::uint32_t top = *link;
      const Ends other = ends(top);
      if (same(other.a, own.b) && same(other.b, own.a)) {
        if (below_.empty() || below_[top] == kNone)
          *link = next_[top];
        else
          replace(*link, below_[top]);
        return top;
      }
      if (!same(other.a, own.a) || !same(other.b, own.b)) continue;
      if (below_.empty()) below_.resize(to_.size(), kNone);
      below_[edge] = top;
      replace(*link, edge);
      return kNone;
    }
    *link = edge;
    return kNone;
  }

 private:
  Ends ends(std::uint32_t edge) const { return {points_[edge], points_[to_[edge]]}; }
  void replace(std::uint32_t& link, std::uint32_t edge) {
    next_[edge] = next_[link];
    link = edge;
  }

  std::span<const Vec2> points_;
  std::span<const std::uint32_t> to_;
  std::vector<std::uint32_t> heads_, next_;
  std::vector<std::uint32_t> below_;  // empty while no edge repeats
};

}  // namespace

std::vector<std::uint32_t> outline_edges(std::span<const Vec2> points,
                                         std::span<const std::uint32_t> to) {
  Standing standing(points, to);
  const auto count = static_cast<std::uint32_t>(to.size());
  std::vector<bool> gone(to.size(), false);
  std::array<std::size_t, kAhead> chains;
  for (std::uint32_t begin = 0; begin < count; begin += kAhead) {
    const std::uint32_t end = std::min(begin + kAhead, count);
    for (std::uint32_t i = begin; i < end; ++i) chains[i - begin] = standing.chain_of(i);
    for (std::uint32_t i = begin; i < end; ++i) {
      gone[i] = !standing.has_length(i);
      if (gone[i]) continue;
      const std::uint32_t partner = standing.cancel_or_add(i, chains[i - begin]);
      if (partner != kNone) gone[i] = gone[partner] = true;
    }
  }
  std::vector<std::uint32_t> left;
  for (std::uint32_t i = 0; i < count; ++i)
    if (!gone[i]) left.push_back(i);
  return left;
}

}  // namespace flatray
