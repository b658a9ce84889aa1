#include <algorithm>
#include <array>
#include <utility>

#include "base/check.h"
#include "geom/ring_sweep.h"

namespace flatray {
namespace {

using Index = std::uint32_t;
constexpr std::int32_t kCut = -1;
constexpr Index kNone = RingSweep::kNone, kNoTwin = kNone;

// One side of a triangle, 3 in a row, counter-clockwise.
struct HalfEdge {
  Index from;            // index of a point
  Index twin = kNoTwin;  // the same side seen from the next triangle; kNoTwin on the outline
};

enum End : std::size_t { kLow = 0, kHigh = 1 };

// Triangles of a simple polygon, by a sweep. Exact, from its own corners only.
//
// Needs   a ring counter-clockwise, simple, without flat corners.
// Gives   3 half-edges a triangle, points - 2 triangles, each of positive area.
// Cost    O(n log n).
//
// Between two neighbouring edges that a sweep meets and that have the polygon between them, what
// lies left of the sweep is cut into triangles up to a front: a chain of vertices from the lower
// edge to the upper one, at none of which a triangle fits. It runs to the right as far as its last
// vertex and back to the left from there. So a new vertex, which lies right of all, sees a stretch
// of it from either end on, and of any front its last vertex (Hertel and Mehlhorn 1983).
class Triangulation {
 public:
  explicit Triangulation(std::span<const Vec2> points)
      : points_(points), sweep_(points), fronts_(points.size()) {}

  std::vector<HalfEdge> run() {
    while (const auto event = sweep_.next()) take(*event);
    FLATRAY_CHECK(sides_.size() + 6 == 3 * points_.size(), "the ring is not simple");
    return std::move(sides_);
  }

 private:
  // A vertex of a front. Its links lead to its neighbours towards either end. A seam is a diagonal
  // whose one half-edge may still be missing.
  struct Link {
    Index node = kNone, seam = kNone;
  };
  struct Node {
    Index vertex;
    std::array<Link, 2> links{};
  };
  struct Front {
    std::array<Index, 2> ends{kNone, kNone};
    Index last = kNone;
  };

  // The interior lies above edges that run to the right, on which their fronts are kept.
  void take(const RingSweep::Event& event) {
    const Index vertex = event.vertex;
    switch (event.kind) {
      case RingSweep::Event::Kind::start:
        if (event.first == vertex) return grow(fronts_[vertex] = {}, kLow, vertex, kNone);
        return split(fronts_[event.below], fronts_[event.second], vertex);
      case RingSweep::Event::Kind::pass:
        if (event.first == vertex) return grow(fronts_[event.below], kHigh, vertex, kNone);
        return grow(fronts_[vertex] = fronts_[event.first], kLow, vertex, kNone);
      case RingSweep::Event::Kind::end:
        if (event.first != vertex) return grow(fronts_[event.first], kLow, vertex, kNone);
        return join(fronts_[event.below], fronts_[event.second], vertex);
    }
  }

  // A vertex becomes the end of a front, with a triangle for each of its sides it sees from there.
  void grow(Front& front, End end, Index vertex, Index seam) {
    const End away = end == kLow ? kHigh : kLow;
    Index first = front.ends[end];
    while (first != kNone && nodes_[first].links[away].node != kNone) {
      const Link& side = nodes_[first].links[away];
      const Index near = nodes_[first].vertex, far = nodes_[side.node].vertex;
      const Index low = end == kLow ? near : far, high = end == kLow ? far : near;
      if (orientation(points_[low], points_[vertex], points_[high]) != Sign::positive) break;
      const Index beyond = add_seam();
      add_side(low, end == kLow ? seam : beyond);
      add_side(vertex, end == kLow ? beyond : seam);
      add_side(high, side.seam);
      seam = beyond;
      first = side.node;
    }
    front.ends[end] = front.last = add_node({vertex});
    if (first == kNone)
      front.ends[away] = front.last;
    else
      link(first, end, front.last, seam);
  }

  // A vertex between the edges of a front parts it at its last vertex.
  void split(Front& lower, Front& upper, Index vertex) {
    const Index last = lower.last, copy = add_node(nodes_[last]);
    upper = {{copy, lower.ends[kHigh] == last ? copy : lower.ends[kHigh]}, copy};
    lower.ends[kHigh] = last;
    const Link beyond = nodes_[last].links[kHigh];
    if (beyond.node != kNone) link(copy, kHigh, beyond.node, beyond.seam);
    nodes_[last].links[kHigh] = nodes_[copy].links[kLow] = {};
    const Index seam = add_seam();
    grow(lower, kHigh, vertex, seam);
    grow(upper, kLow, vertex, seam);
  }

  // Two fronts end at a vertex, and go on as one.
  void join(Front& lower, Front& upper, Index vertex) {
    grow(lower, kHigh, vertex, kNone);
    grow(upper, kLow, vertex, kNone);
    const Link beyond = nodes_[upper.last].links[kHigh];
    link(lower.last, kHigh, beyond.node, beyond.seam);
    lower.ends[kHigh] = upper.ends[kHigh];
  }

  void link(Index node, End end, Index other, Index seam) {
    nodes_[node].links[end] = {other, seam};
    nodes_[other].links[end == kLow ? kHigh : kLow] = {node, seam};
  }
  Index add_node(const Node& node) {
    nodes_.push_back(node);
    return static_cast<Index>(nodes_.size() - 1);
  }
  Index add_seam() {
    seams_.push_back(kNoTwin);
    return static_cast<Index>(seams_.size() - 1);
  }

  void add_side(Index from, Index seam) {
    const Index side = static_cast<Index>(sides_.size());
    Index twin = kNoTwin;
    if (seam != kNone) {
      twin = std::exchange(seams_[seam], side);
      if (twin != kNoTwin) sides_[twin].twin = side;
    }
    sides_.push_back({from, twin});
  }

  std::span<const Vec2> points_;
  RingSweep sweep_;
  std::vector<Front> fronts_;  // by the edge below
  std::vector<Node> nodes_;
  std::vector<Index> seams_;  // the half-edge that is there
  std::vector<HalfEdge> sides_;
};

// A ring walked counter-clockwise: where each edge of positive length begins, and its number as
// given.
struct Walk {
  std::vector<Vec2> points;
  std::vector<std::int32_t> edges;

  explicit Walk(std::span<const Vec2> ring) {
    for (const std::size_t edge : proper_edges(ring)) {
      points.push_back(ring[edge]);
      edges.push_back(static_cast<std::int32_t>(edge));
    }
    if (ring_orientation(points) != Sign::negative) return;
    // The edge that began at a vertex now ends there.
    std::reverse(points.begin(), points.end());
    std::reverse(edges.begin(), edges.end() - 1);
  }
  Index size() const { return static_cast<Index>(points.size()); }
  Index after(Index i) const { return i + 1 == size() ? 0 : i + 1; }
  Index before(Index i) const { return i == 0 ? size() - 1 : i - 1; }
};

// Triangles between the vertices at which a walk turns.
std::vector<HalfEdge> triangles_of(const Walk& walk) {
  std::vector<Index> corners;
  std::vector<Vec2> points;
  for (Index i = 0; i < walk.size(); ++i) {
    const Vec2& point = walk.points[i];
    if (orientation(walk.points[walk.before(i)], point, walk.points[walk.after(i)]) == Sign::zero)
      continue;
    corners.push_back(i);
    points.push_back(point);
  }
  std::vector<HalfEdge> sides = Triangulation(points).run();
  for (HalfEdge& side : sides) side.from = corners[side.from];
  return sides;
}

// Faces of triangles, joined where what results is convex (Hertel and Mehlhorn 1983: at most four
// times as many pieces as the least number).
class Faces {
 public:
  Faces(const Walk& walk, std::vector<HalfEdge> sides) : walk_(walk), sides_(std::move(sides)) {
    links_.resize(sides_.size());
    for (Index h = 0; h < links_.size(); ++h) {
      const Index base = h / 3 * 3;
      links_[h] = {base + (h + 1) % 3, base + (h + 2) % 3};
    }
  }

  void join() {
    for (Index h = 0; h < sides_.size(); ++h) {
      const Index twin = sides_[h].twin;
      if (twin == kNoTwin || twin > h) continue;  // in the order in which they were cut
      if (is_convex_without(h, twin) && is_convex_without(twin, h)) {
        bridge(h, twin);
        bridge(twin, h);
        links_[h].gone = links_[twin].gone = true;
      }
    }
  }

  ConvexPieces pieces() {
    ConvexPieces pieces;
    for (Index h = 0; h < sides_.size(); ++h) {
      if (links_[h].gone) continue;
      for (Index at = h; !links_[at].gone; at = links_[at].next) {
        links_[at].gone = true;
        add_side(at, pieces);
      }
      pieces.begin.push_back(static_cast<std::uint32_t>(pieces.vertices.size()));
    }
    return pieces;
  }

 private:
  struct Link {
    Index next, before;
    bool gone = false;
  };

  const Vec2& start(Index h) const { return walk_.points[sides_[h].from]; }

  // Whether the corner where h begins stays convex when h and its twin are taken out.
  bool is_convex_without(Index h, Index twin) const {
    const Index in = links_[h].before, out = links_[twin].next;
    return orientation(start(in), start(h), start(links_[out].next)) != Sign::negative;
  }
  void bridge(Index h, Index twin) {
    links_[links_[h].before].next = links_[twin].next;
    links_[links_[twin].next].before = links_[h].before;
  }

  // A side of the outline brings back the flat vertices on it.
  void add_side(Index h, ConvexPieces& pieces) const {
    const Index from = sides_[h].from, to = sides_[links_[h].next].from;
    const bool cut = sides_[h].twin != kNoTwin;
    for (Index i = from; i != to; i = cut ? to : walk_.after(i)) {
      pieces.vertices.push_back(walk_.points[i]);
      pieces.edges.push_back(cut ? kCut : walk_.edges[i]);
    }
  }

  const Walk& walk_;
  std::vector<HalfEdge> sides_;
  std::vector<Link> links_;
};

}  // namespace

ConvexPieces convex_pieces(std::span<const Vec2> ring) {
  Walk walk(ring);
  if (!non_convex_vertex(walk.points)) {
    const std::uint32_t size = walk.size();
    return {std::move(walk.points), {0, size}, std::move(walk.edges)};
  }
  Faces faces(walk, triangles_of(walk));
  faces.join();
  return faces.pieces();
}

}  // namespace flatray
