#include "render/monotone_ring.h"

#include <cmath>

namespace flatray {
namespace {

// Changes between down and up along a ring of edges; level ones change nothing.
int turns(const std::vector<Segment>& edges) {
  int count = 0, first = 0, last = 0;
  for (const Segment& edge : edges) {
    const int way = (edge.a.y() < edge.b.y() ? 1 : 0) - (edge.b.y() < edge.a.y() ? 1 : 0);
    if (way == 0) continue;
    if (first == 0) first = way;
    if (last == -way) ++count;
    last = way;
  }
  return count + (first == last ? 0 : 1);
}

// Whether each edge begins where the one before it in the list ends, the last being before the first.
bool joined(const std::vector<Segment>& edges, Vec2 Segment::*begin, Vec2 Segment::*end) {
  const Segment* before = &edges.back();
  for (const Segment& edge : edges) {
    const Vec2 &from = before->*end, &to = edge.*begin;
    if (from.x() != to.x() || from.y() != to.y()) return false;
    before = &edge;
  }
  return true;
}

bool near_film(const Vec2& p) {
  return std::abs(p.x()) <= kMonotoneReach && std::abs(p.y()) <= kMonotoneReach;
}

}  // namespace

bool append_monotone_ring(const FillPath& path, std::size_t most, std::vector<Corner>& corners) {
  const std::vector<Segment>& edges = path.edges;
  if (!path.simple || edges.empty() || edges.size() > most || turns(edges) > 2) return false;
  Vec2 Segment::*corner = &Segment::a;
  if (!joined(edges, &Segment::a, &Segment::b)) {
    if (!joined(edges, &Segment::b, &Segment::a)) return false;
    corner = &Segment::b;  // listed against their direction
  }
  std::size_t top = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Vec2& p = edges[i].*corner;
    if (!near_film(p)) return false;
    if (p.y() < (edges[top].*corner).y()) top = i;
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Vec2& p = edges[top + i < edges.size() ? top + i : top + i - edges.size()].*corner;
    corners.push_back({p.x(), p.y()});
  }
  return true;
}

}  // namespace flatray
