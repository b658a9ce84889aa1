#pragma once
#include "scene/scene.h"

namespace flatray {

/// A directed edge of a shape's outline: from one of its vertices to another.
struct OutlineEdge {
  std::uint32_t from, to;  ///< of Shape::vertices
  std::int32_t number;     ///< of the input
  bool turned;             ///< the input's runs the other way
};

/// Edges of the convex pieces that bound their union as far as shared edges tell: what two pieces
/// run along in opposite directions, cuts among them, is inside the shape. Counter-clockwise; of one
/// piece in its order, of several in that of their numbers, whichever pieces these are.
std::vector<OutlineEdge> outline(const Shape& shape);

}  // namespace flatray
