#pragma once

namespace flatray {

/// Sums over points from which a straight line is fitted by least squares.
struct LineFit {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;

  void add(double at, double value, double weight = 1) {
    n += weight;
    x += weight * at;
    y += weight * value;
    xx += weight * at * at;
    xy += weight * at * value;
  }
  /// Above 0 where there is a line.
  double spread() const { return n * xx - x * x; }
  double slope() const { return (n * xy - x * y) / spread(); }
};

}  // namespace flatray
