#include "scene/outlines/outline.h"

#include <algorithm>

#include "geom/outline.h"

namespace flatray {
namespace {

struct Walk {
  const Shape& shape;
  std::size_t piece = 0;

  // Edge i runs from vertex i to the next of its piece. Needs   ascending i.
  OutlineEdge edge(std::uint32_t i) {
    while (i >= shape.begin[piece + 1]) ++piece;
    return {i, i + 1 < shape.begin[piece + 1] ? i + 1 : shape.begin[piece], shape.edges[i],
            piece < shape.clockwise.size() && shape.clockwise[piece]};
  }
};

}  // namespace

std::vector<OutlineEdge> outline(const Shape& shape) {
  const auto count = static_cast<std::uint32_t>(shape.vertices.size());
  std::vector<OutlineEdge> edges;
  if (shape.piece_count() < 2) {
    edges.reserve(count);
    for (Walk walk{shape}; edges.size() < count;)
      edges.push_back(walk.edge(static_cast<std::uint32_t>(edges.size())));
    return edges;
  }
  std::vector<std::uint32_t> ends;
  ends.reserve(count);
  for (Walk walk{shape}; ends.size() < count;)
    ends.push_back(walk.edge(static_cast<std::uint32_t>(ends.size())).to);
  Walk walk{shape};
  for (const std::uint32_t i : outline_edges(shape.vertices, ends)) edges.push_back(walk.edge(i));
  std::ranges::stable_sort(edges, [](const auto& a, const auto& b) { return a.number < b.number; });
  return edges;
}

}  // namespace flatray
