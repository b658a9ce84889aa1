#include "geom/polygon.h"

#include <algorithm>

#include "geom/bounds.h"
#include "geom/decide.h"
#include "geom/ring_sweep.h"

namespace flatray {
namespace {

// The turns of a ring, walked once round.
struct Turns {
  bool left = false, right = false;
  int changes = 0;               // between running forward and backward, in x, then y
  std::size_t third_change = 0;  // the vertex where it turns back for the third time
};

// The turn at the start of proper edge k.
Sign turn_at(std::span<const Vec2> ring, std::span<const std::size_t> edges, std::size_t k) {
  const std::size_t before = edges[k == 0 ? edges.size() - 1 : k - 1];
  return orientation(ring[before], ring[edges[k]], edge_end(ring, edges[k]));
}

Turns turns_of(std::span<const Vec2> ring, std::span<const std::size_t> edges) {
  Turns turns;
  bool forward = is_before(ring[edges.back()], ring[edges.front()]);
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const Sign turn = turn_at(ring, edges, k);
    turns.left |= turn == Sign::positive;
    turns.right |= turn == Sign::negative;
    const bool now_forward = is_before(ring[edges[k]], edge_end(ring, edges[k]));
    if (now_forward != forward && ++turns.changes == 3) turns.third_change = edges[k];
    forward = now_forward;
  }
  return turns;
}

}  // namespace

std::vector<std::size_t> proper_edges(std::span<const Vec2> ring) {
  std::vector<std::size_t> edges;
  edges.reserve(ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (ring[i] != edge_end(ring, i)) edges.push_back(i);
  return edges;
}

StartPlace place_in_convex(const Vec2& point, std::span<const Vec2> ring) {
  bool left = false, right = false, on_line = false;
  Bounds bounds;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 &a = ring[i], &b = edge_end(ring, i);
    bounds.add(a);
    const Sign side = orientation(a, b, point);
    left |= side == Sign::positive;
    right |= side == Sign::negative;
    on_line |= side == Sign::zero && a != b;
  }
  if (left && right) return StartPlace::outside;
  if (left || right) return on_line ? StartPlace::boundary : StartPlace::inside;
  // On the line of every edge: the ring is a segment or a point, which its bounds describe.
  return bounds.contains(point) ? StartPlace::boundary : StartPlace::outside;
}

Sign ring_orientation(std::span<const Vec2> ring) {
  if (ring.size() < 3) return Sign::zero;
  // Twice the area as a fan about vertex 0, by terms or all in one arithmetic.
  const auto area = [&](const auto& number, auto sum) {
    for (std::size_t i = 1; i + 1 < ring.size(); ++i)
      sum = sum + determinant(number, ring[0], ring[i], ring[0], ring[i + 1]);
    return sum;
  };
  if (const auto sign = area(kCounted, Near(0)).sign()) return *sign;
  return decide([&](const auto& number) { return area(number, number(0.0)); });
}

double ring_area(std::span<const Vec2> ring) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i)
    twice += cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
  return 0.5 * twice;
}

std::optional<std::size_t> non_convex_vertex(std::span<const Vec2> ring) {
  const std::vector<std::size_t> edges = proper_edges(ring);
  if (edges.size() < 3) return std::nullopt;
  const Turns turns = turns_of(ring, edges);
  if (!turns.left && !turns.right) return std::nullopt;  // all in one line
  if (turns.left != turns.right) {
    // It turns one way only. Each time round it changes its running twice: in one round it is
    // convex.
    if (turns.changes <= 2) return std::nullopt;
    return turns.third_change;
  }
  Sign wanted = ring_orientation(ring);
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const Sign turn = turn_at(ring, edges, k);
    if (wanted == Sign::zero) wanted = turn;  // no area: the first turn sets the sense
    if (turn != Sign::zero && turn != wanted) return edges[k];
  }
  return turns.third_change;
}

void mend_convex(std::vector<Vec2>& ring) {
  const std::size_t n = ring.size();
  if (n < 3) return;
  const auto turn = [&](std::size_t a, std::size_t b, std::size_t c) {
    return orientation(ring[a % n], ring[b % n], ring[c % n]);
  };
  // Where it turns one way everywhere it winds as often as it did before.
  const Sign first = turn(0, 1, 2);
  std::size_t same = first == Sign::zero ? 0 : 1;
  while (same != 0 && same < n && turn(same, same + 1, same + 2) == first) ++same;
  if (same == n || !non_convex_vertex(ring)) return;
  // Once round from a corner that is outermost (Graham 1972).
  const Sign inward = -ring_orientation(ring);
  const auto begin = static_cast<std::size_t>(
      std::min_element(ring.begin(), ring.end(), is_before) - ring.begin());
  std::vector<std::size_t> kept;
  for (std::size_t i = begin; i <= begin + n; ++i) {
    while (kept.size() > 1 && turn(kept[kept.size() - 2], kept.back(), i) == inward)
      kept.pop_back();
    if (kept.empty() || ring[kept.back() % n] != ring[i % n]) kept.push_back(i);
  }
  for (std::size_t k = 0; k < kept.size(); ++k) {
    const std::size_t end = k + 1 < kept.size() ? kept[k + 1] : begin + n;
    for (std::size_t i = kept[k] + 1; i < end; ++i) ring[i % n] = ring[kept[k] % n];
  }
  // What is left goes back and forth along a line.
  while (const auto inside = non_convex_vertex(ring)) {
    const Vec2 corner = ring[*inside];  // those that were moved onto it go with it
    std::size_t before = *inside;
    while (ring[before] == corner) before = (before + n - 1) % n;
    for (std::size_t i = (before + 1) % n; ring[i] == corner; i = (i + 1) % n)
      ring[i] = ring[before];
  }
}

std::optional<CrossingEdges> crossing_edges(std::span<const Vec2> ring) {
  const std::vector<std::size_t> edges = proper_edges(ring);
  std::vector<Vec2> points;
  points.reserve(edges.size());
  for (const std::size_t edge : edges) points.push_back(ring[edge]);
  RingSweep sweep(points);
  while (sweep.next()) {
  }
  if (!sweep.crossing()) return std::nullopt;
  return CrossingEdges{edges[sweep.crossing()->first], edges[sweep.crossing()->second]};
}

}  // namespace flatray
