#pragma once
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geom/bounds.h"
#include "study/experiment.h"
#include "study/plots/drawing.h"
#include "study/plots/palette.h"

namespace flatray {

/// Numbers against numbers, as points, lines or a map of colours.
struct Plot {
  std::string title, x_label, y_label;
  struct Point {
    double x, y, half = 0;  ///< half of the interval of y
    std::string label{};    ///< words beside it
    double half_x = 0;      ///< half of the interval of x
    bool ringed = false;
  };
  /// Parts a line.
  static Point gap() { return {std::numeric_limits<double>::quiet_NaN(), 0}; }
  struct Series {
    std::string name;  ///< in the legend; "" is not
    std::vector<Point> points{};
    bool marks = false;  ///< points with their intervals; else a line
    std::string ink{};   ///< instead of the next one of series_ink
    double width = 1.5;  ///< of the line; half of the radius of a mark
  };
  std::vector<Series> series{};
  bool log_y = false;     ///< points with y <= 0 are left out
  bool log_x = false;     ///< likewise
  std::string caption{};  ///< below
  /// Pixels that stand for places of the axes, which are these bounds.
  struct Map {
    Image image;
    Bounds bounds;
  };
  std::optional<Map> map{};
  /// Which colour is which number: a column of pixels, and numbers at parts of it from below, of which
  /// those are shown that have room.
  struct Bar {
    std::string label;
    Image strip;
    std::vector<std::pair<double, std::string>> ticks;
  };
  std::optional<Bar> bar{};
  /// Which colour is which kind.
  std::vector<std::pair<std::string, std::string>> kinds{};  ///< colour, name
  std::optional<Bounds> window{};  ///< what the axes show; else all points
  double y_step = 0;               ///< of its ticks, where it is not one of tens
  bool equal = false;              ///< x and y are in one scale
};

/// The plot with axes, ticks, a light grid, and below them a legend of the series that have points.
/// Labels of points overlap neither each other nor points, as far as there is room.
/// Gives   a drawing 520 units wide, or less where it is upright.
Drawing drawing_of(const Plot& plot);

/// A plot as SVG: see study/plots/drawing.h.
std::string svg(const Plot& plot);

/// A bar from 0 to `most`: the colour at each part of it, and where on it a number stands, evenly
/// if nothing else is said.
Plot::Bar bar_of(std::string label, double most, const std::function<LinearRgb(double)>& colour,
                 const std::function<double(double)>& part_of = {});
/// log(1 + number) of that of `most`; 0 where that is 0.
double log_share(double number, double most);

/// A plot as files NAME.svg and NAME.png, that of 1000 pixels on its longer side, and of up to 4000
/// where not every pixel of a map would be seen else.
void add_plot(ExperimentResult& result, const std::string& name, const Plot& plot,
              unsigned threads);

/// The same, and NAME_pixels.csv with the numbers behind the map: a line for each row of pixels,
/// with its y first, under a line of their x; "" where there is none.
void add_map(ExperimentResult& result, const std::string& name, const Plot& plot, unsigned threads,
             const std::function<std::string(std::size_t)>& cell);

/// Shares over a grid of two numbers.
struct HeatMap {
  std::string title, x_label, y_label;
  std::vector<double> x, y;    ///< evenly apart
  std::vector<double> shares;  ///< by y, then x: 0 to 1
};

/// From yellow for 0 to dark red, by the fourth root, so that a single wrong one is seen.
Plot plot_of(const HeatMap& map);

}  // namespace flatray
