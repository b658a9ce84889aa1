#include <algorithm>
#include <bit>

#include "geom/bounds.h"
#include "geom/polygon.h"
#include "geom/polygon_edges.h"

namespace flatray {
namespace {

bool overlap(const Bounds& a, const Bounds& b) {
  return a.low.x() <= b.high.x() && b.low.x() <= a.high.x() && a.low.y() <= b.high.y() &&
         b.low.y() <= a.high.y();
}

Bounds bounds_of(const Segment& s) { return {s.a.cwiseMin(s.b), s.a.cwiseMax(s.b)}; }

// Whether two closed segments have a point in common.
bool meet(const Segment& s, const Segment& t) {
  if (!overlap(bounds_of(s), bounds_of(t))) return false;
  const Sign a = orientation(s.a, s.b, t.a), b = orientation(s.a, s.b, t.b);
  if (a == b && a != Sign::zero) return false;
  const Sign c = orientation(t.a, t.b, s.a), d = orientation(t.a, t.b, s.b);
  return c != d || c == Sign::zero;
}

// Whether an edge runs back over the one before it, which ends where it begins.
bool folds_back(const Segment& before, const Segment& edge) {
  if (orientation(before.a, before.b, edge.b) != Sign::zero) return false;
  const auto same_way = [](double from, double by, double to) { return (from < by) == (by < to); };
  return before.a.x() != before.b.x() ? !same_way(before.a.x(), before.b.x(), edge.b.x())
                                      : !same_way(before.a.y(), before.b.y(), edge.b.y());
}

// Boxes of runs of edges, halved down to single edges: neighbours in a ring are neighbours in the
// plane, so two runs that are apart are told by one comparison.
class EdgeTree {
 public:
  explicit EdgeTree(std::span<const Vec2> ring)
      : ring_(ring), edges_(proper_edges(ring)), boxes_(2 * std::bit_ceil(edges_.size() + 1)) {
    if (!edges_.empty()) build(1, 0, edges_.size());
  }

  std::optional<CrossingEdges> find() const {
    if (edges_.empty()) return std::nullopt;
    return within({1, 0, edges_.size()});
  }

 private:
  struct Run {
    std::size_t node, begin, end;
    std::size_t size() const { return end - begin; }
    std::size_t middle() const { return begin + size() / 2; }
    Run first() const { return {2 * node, begin, middle()}; }
    Run second() const { return {2 * node + 1, middle(), end}; }
  };

  Segment segment(std::size_t k) const { return {ring_[edges_[k]], edge_end(ring_, edges_[k])}; }

  void build(std::size_t node, std::size_t begin, std::size_t end) {
    const Run run{node, begin, end};
    if (run.size() == 1) {
      boxes_[node] = bounds_of(segment(begin));
      return;
    }
    build(2 * node, begin, run.middle());
    build(2 * node + 1, run.middle(), end);
    boxes_[node] = boxes_[2 * node];
    boxes_[node].add(boxes_[2 * node + 1]);
  }

  std::optional<CrossingEdges> within(const Run& run) const {
    if (run.size() == 1) return std::nullopt;
    if (const auto found = within(run.first())) return found;
    if (const auto found = within(run.second())) return found;
    return between(run.first(), run.second());
  }

  std::optional<CrossingEdges> between(const Run& a, const Run& b) const {
    if (!overlap(boxes_[a.node], boxes_[b.node])) return std::nullopt;
    if (a.size() == 1 && b.size() == 1) return check(a.begin, b.begin);
    const bool split_a = a.size() >= b.size();
    const auto found = split_a ? between(a.first(), b) : between(a, b.first());
    if (found) return found;
    return split_a ? between(a.second(), b) : between(a, b.second());
  }

  // i < k
  std::optional<CrossingEdges> check(std::size_t i, std::size_t k) const {
    const bool k_follows = i + 1 == k, i_follows = i == 0 && k + 1 == edges_.size();
    const Segment s = segment(i), t = segment(k);
    const bool crossing = k_follows || i_follows
                              ? (k_follows && folds_back(s, t)) || (i_follows && folds_back(t, s))
                              : meet(s, t);
    if (!crossing) return std::nullopt;
    return CrossingEdges{edges_[i], edges_[k]};
  }

  std::span<const Vec2> ring_;
  std::vector<std::size_t> edges_;
  std::vector<Bounds> boxes_;  // node i has the children 2 i and 2 i + 1
};

}  // namespace

std::optional<CrossingEdges> crossing_edges(std::span<const Vec2> ring) {
  return EdgeTree(ring).find();
}

}  // namespace flatray
