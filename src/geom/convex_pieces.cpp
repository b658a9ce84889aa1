#include <algorithm>

#include "geom/polygon.h"
#include "geom/triangulate.h"

namespace flatray {
namespace {

using Index = std::uint32_t;
constexpr std::int32_t kCut = -1;

// A ring walked counter-clockwise: where each edge of positive length begins, and its number as
// given.
struct Walk {
  std::vector<Vec2> points;
  std::vector<std::int32_t> edges;
  bool clockwise;

  explicit Walk(std::span<const Vec2> ring) {
    for (const std::size_t edge : proper_edges(ring)) {
      points.push_back(ring[edge]);
      edges.push_back(static_cast<std::int32_t>(edge));
    }
    clockwise = ring_orientation(points) == Sign::negative;
    if (!clockwise) return;
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
  std::vector<HalfEdge> sides = triangulate(points);
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
    pieces.clockwise = walk_.clockwise;
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
    return {std::move(walk.points), {0, size}, std::move(walk.edges), walk.clockwise};
  }
  Faces faces(walk, triangles_of(walk));
  faces.join();
  return faces.pieces();
}

}  // namespace flatray
