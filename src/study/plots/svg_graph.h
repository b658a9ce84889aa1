#pragma once
#include <string>
#include <vector>

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
/// arrows. Gives   well-formed XML of any text given; the same bytes on every machine.
std::string svg(const StateGraph& graph);

}  // namespace flatray
