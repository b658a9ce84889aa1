#include "geom/triangulate.h"

#include <array>
#include <utility>

#include "base/check.h"
#include "geom/ring_sweep.h"

namespace flatray {
namespace {

using Index = std::uint32_t;
constexpr Index kNone = RingSweep::kNone;
enum End : std::size_t { kLow = 0, kHigh = 1 };

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

}  // namespace

std::vector<HalfEdge> triangulate(std::span<const Vec2> points) {
  return Triangulation(points).run();
}

}  // namespace flatray
