#pragma once
#include <variant>
#include <vector>

#include "anim/frame_state.h"
#include "geom/ellipse.h"

namespace flatray {

/// Linear light with straight alpha.
struct LinearColour {
  float r = 0, g = 0, b = 0, a = 1;
};

/// Region bounded by directed edges in film coordinates (pixels, y down): the winding number at a
/// point counts the edges it passes. Edges that cancel have been left out. Need not be one ring;
/// every vertex is balanced.
struct FillPath {
  std::vector<Segment> edges;
  FillRule rule = FillRule::nonzero;
  bool simple = false;  ///< winding is 0 or 1 everywhere: one convex piece, or proven so
};

/// Disc or ring in film coordinates; inner_radius < 0 is a whole disc.
struct FillRing {
  Vec2 centre;
  double radius, inner_radius = -1;
};

/// Region inside a closed path of arcs and straight lines in film coordinates that crosses itself
/// nowhere.
struct FillArcs {
  ArcPath path;
};

struct DrawItem {
  std::variant<FillPath, FillRing, FillArcs> region;
  LinearColour colour;
};

/// What every back end draws: items in order, over the background.
struct DrawList {
  int width = 0, height = 0;
  LinearColour background;
  Coverage coverage = Coverage::area;
  std::vector<DrawItem> items;
};

}  // namespace flatray
