#pragma once
#include <string>
#include <vector>

namespace flatray {

/// Numbers against numbers.
struct Plot {
  std::string title, x_label, y_label;
  struct Point {
    double x, y, half = 0;  ///< half of the interval of y
  };
  struct Series {
    std::string name;
    std::vector<Point> points;
    bool marks = false;  ///< points with their intervals; else a line
  };
  std::vector<Series> series;
  bool log_y = false;  ///< points with y <= 0 are left out
  bool log_x = false;  ///< likewise
  /// A ring round a point of a series, and words beside it.
  struct Note {
    double x, y;
    std::string words;
  };
  std::vector<Note> notes{};
};

/// The plot as a picture with axes, ticks and a legend of the series that have points.
/// Gives   well-formed XML of any text given; the same bytes on every machine.
std::string svg(const Plot& plot);

}  // namespace flatray
