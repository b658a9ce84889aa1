#pragma once
#include <string>
#include <vector>

namespace flatray {

/// Shares over a grid of two numbers.
struct HeatMap {
  std::string title, x_label, y_label;
  std::vector<double> x, y;    ///< evenly apart
  std::vector<double> shares;  ///< by y, then x: 0 to 1
};

/// The map as a picture: white for 0, then from yellow to dark red, so that a single wrong one is
/// seen. Gives   well-formed XML of any text given; the same bytes on every machine.
std::string svg(const HeatMap& map);

}  // namespace flatray
