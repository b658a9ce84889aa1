#include "scene/outline.h"

#include "geom/outline.h"

namespace flatray {

std::vector<OutlineEdge> outline(const Shape& shape) {
  std::vector<OutlineEdge> edges;
  std::vector<Segment> segments;
  edges.reserve(shape.vertices.size());
  segments.reserve(shape.vertices.size());
  for (std::size_t piece = 0; piece < shape.piece_count(); ++piece) {
    const std::uint32_t begin = shape.begin[piece], end = shape.begin[piece + 1];
    for (std::uint32_t i = begin; i < end; ++i) {
      const std::uint32_t next = i + 1 < end ? i + 1 : begin;
      edges.push_back({i, next, shape.edges[i]});
      segments.push_back({shape.vertices[i], shape.vertices[next]});
    }
  }
  if (shape.piece_count() < 2) return edges;
  std::vector<OutlineEdge> left;
  for (const std::uint32_t i : outline_edges(segments)) left.push_back(edges[i]);
  return left;
}

}  // namespace flatray
