#include "anim/world.h"

#include <algorithm>
#include <tuple>

#include "geom/hit_interval.h"

namespace flatray {
namespace {

constexpr std::int32_t kCut = -1;  // Shape::edges: between two pieces, not of the input

// An edge of a piece, with its ends in an order that both of its directions share.
struct PieceEdge {
  std::size_t from, to;
  std::int32_t number;
  Vec2 low, high;
  bool forward;
};

PieceEdge piece_edge(const Shape& shape, std::size_t from, std::size_t to) {
  const Vec2 &a = shape.vertices[from], &b = shape.vertices[to];
  const bool forward = std::tie(a.x(), a.y()) < std::tie(b.x(), b.y());
  return {from, to, shape.edges[from], forward ? a : b, forward ? b : a, forward};
}

std::vector<PieceEdge> piece_edges(const Shape& shape) {
  std::vector<PieceEdge> edges;
  for (std::size_t piece = 0; piece < shape.piece_count(); ++piece)
    for (std::size_t k = shape.begin[piece]; k < shape.begin[piece + 1]; ++k) {
      const std::size_t next = k + 1 < shape.begin[piece + 1] ? k + 1 : shape.begin[piece];
      if (shape.edges[k] != kCut && shape.vertices[k] != shape.vertices[next])
        edges.push_back(piece_edge(shape, k, next));
    }
  return edges;
}

auto ends_of(const PieceEdge& edge) {
  return std::tie(edge.low.x(), edge.low.y(), edge.high.x(), edge.high.y());
}

// Two pieces that meet in an edge run along it in opposite directions: that edge is inside the
// shape. What is left keeps the order of the shape.
std::vector<PieceEdge> outline(const Shape& shape) {
  std::vector<PieceEdge> edges = piece_edges(shape);
  if (shape.piece_count() < 2) return edges;
  std::stable_sort(edges.begin(), edges.end(),
                   [](const PieceEdge& a, const PieceEdge& b) { return ends_of(a) < ends_of(b); });
  std::vector<PieceEdge> left;  // of one place: edges of one direction only
  std::size_t place = 0;
  for (const PieceEdge& edge : edges) {
    if (left.size() > place && ends_of(left.back()) != ends_of(edge)) place = left.size();
    if (left.size() > place && left.back().forward != edge.forward)
      left.pop_back();
    else
      left.push_back(edge);
  }
  std::sort(left.begin(), left.end(),
            [](const PieceEdge& a, const PieceEdge& b) { return a.from < b.from; });
  return left;
}

void add_segment(World& world, const Vec2& a, const Vec2& b, const SurfaceOwner& owner) {
  if (a == b) return;  // so small and so far away that the doubles do not tell its ends apart
  world.surfaces.add(Segment{a, b});
  world.owners.push_back(owner);
}

void add_shape(World& world, const Shape& shape, const Pose& place, SurfaceOwner owner) {
  for (const PieceEdge& edge : outline(shape)) {
    owner.edge = edge.number;
    add_segment(world, place(shape.vertices[edge.from]), place(shape.vertices[edge.to]), owner);
  }
  owner.edge = 0;
  for (const Segment& segment : shape.segments) {
    add_segment(world, place(segment.a), place(segment.b), owner);
    ++owner.edge;
  }
  owner.edge = kNoEdge;
  for (const Circle& circle : shape.circles) {
    world.surfaces.add(Circle{place(circle.centre), circle.radius});
    world.owners.push_back(owner);
  }
}

}  // namespace

World build_world(const Scene& scene, const FrameState& state) {
  using Kind = SurfaceOwner::Kind;
  World world;
  for (std::uint32_t i = 0; i < scene.entities.size(); ++i)
    if (const std::optional<Material> material = scene.entities[i].material)
      add_shape(world, scene.shapes[state.entities[i].shape], entity_pose(state, i),
                {Kind::entity, i, 0, kNoEdge, *material});
  for (std::uint32_t i = 0; i < scene.chambers.size(); ++i) {
    const Chamber& chamber = scene.chambers[i];
    add_shape(world, scene.shapes[chamber.shape], world_pose(state),
              {Kind::chamber, i, 0, kNoEdge, chamber.material});
    for (std::uint32_t j = 0; j < chamber.pillars.size(); ++j)
      add_shape(world, scene.shapes[chamber.pillars[j].shape],
                pillar_pose(state, chamber.pillars[j]),
                {Kind::pillar, i, j, kNoEdge, chamber.pillars[j].material});
  }
  return world;
}

}  // namespace flatray
