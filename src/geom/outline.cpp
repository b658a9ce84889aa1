#include "geom/outline.h"

#include <algorithm>

namespace flatray {
namespace {

// An edge by its line, from its lower end on.
struct OutlineLine {
  Vec2 low, high;
  std::uint32_t edge;
  bool rises;

  bool is_on(const OutlineLine& other) const { return low == other.low && high == other.high; }
  bool operator<(const OutlineLine& other) const {
    if (low != other.low) return is_before(low, other.low);
    return high != other.high ? is_before(high, other.high) : edge < other.edge;
  }
};

}  // namespace

// Of each line the edges still standing run one way: one the other way cancels the newest of them.
std::vector<std::uint32_t> outline_edges(std::span<const Vec2> points,
                                         std::span<const std::uint32_t> to) {
  std::vector<OutlineLine> lines;
  for (std::uint32_t i = 0; i < to.size(); ++i) {
    const Vec2 &a = points[i], &b = points[to[i]];
    if (is_before(a, b)) lines.push_back({a, b, i, true});
    if (is_before(b, a)) lines.push_back({b, a, i, false});
  }
  std::sort(lines.begin(), lines.end());
  std::size_t standing = 0;  // the first of `lines`
  for (const OutlineLine& line : lines) {
    const OutlineLine* const last = standing > 0 ? &lines[standing - 1] : nullptr;
    if (last != nullptr && last->is_on(line) && last->rises != line.rises)
      --standing;
    else
      lines[standing++] = line;
  }
  lines.resize(standing);
  std::vector<std::uint32_t> left;
  left.reserve(standing);
  for (const OutlineLine& line : lines) left.push_back(line.edge);
  std::sort(left.begin(), left.end());
  return left;
}

}  // namespace flatray
