#pragma once
#include <string>
#include <vector>

#include "study/plots/drawing.h"

namespace flatray {

/// States and the transitions between them, each with its label.
struct StateGraph {
  std::string title;
  std::vector<std::string> states;
  struct Arrow {
    std::size_t from, to;
    std::string label;
  };
  std::vector<Arrow> arrows;
};

/// The graph as a picture: states as circles on a ring, clockwise from the top, transitions as
/// arrows.
Drawing drawing_of(const StateGraph& graph);

}  // namespace flatray
