#pragma once
#include "scene/scene.h"

namespace flatray {

/// A directed edge of a shape's outline: from one of its vertices to another.
struct OutlineEdge {
  std::uint32_t from, to;  ///< of Shape::vertices
  std::int32_t number;     ///< of the input
};

/// Edges of the convex pieces that bound their union as far as shared edges tell: what two pieces
/// run along in opposite directions, cuts among them, is inside the shape. In the order of the
/// shape, counter-clockwise.
std::vector<OutlineEdge> outline(const Shape& shape);

}  // namespace flatray
