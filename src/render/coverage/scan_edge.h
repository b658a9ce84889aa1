#pragma once
#include <algorithm>
#include <deque>
#include <span>
#include <vector>

#include "geom/primitives/arc.h"
#include "render/draw_list.h"

namespace flatray {

/// The curve of an edge along an ellipse.
///
/// With half-diameters u, v an ellipse is the x-shear of one along the axes: at the height d over
/// its centre x = k d +- w sqrt(1 - (d / h)^2), where h^2 = u.y^2 + v.y^2,
/// k = (u.x u.y + v.x v.y) / h^2 and w = |u x v| / h; likewise the other way round.
struct EdgeCurve {
  /// One coordinate by the other, as seen from the centre.
  struct Branch {
    double shear = 0, reach = 0, half = 0, inverse = 0;  ///< 1 / half
    double at(double d) const;
    /// By how much d^2 is below half^2, of that: `at` is off by reach 2^-50 over its root.
    double inside(double d) const { return ((half - d) * inverse) * ((half + d) * inverse); }
  };
  Ellipse ellipse;
  Branch x, y;
  double det = 0;   ///< u x v
  double side = 0;  ///< +1 on the right half of the ellipse, else -1
  /// By how far rounding may have moved its ends; how far it may then go beyond them, at those where it
  /// turns back as another edge's curve.
  double rounding = 0, above = 0, below = 0;

  EdgeCurve(const EllipseArc& arc, const MonotoneArc& part);
  /// Area by which the curve has more on its right than the chord between two points of it.
  double bow(double dx, double dy) const;
};

/// An edge of a region, straight or along an ellipse, on which x and y each only rise or only fall,
/// from its upper to its lower end (of a level edge: from the left to the right one).
///
/// Units   film pixels, y down.
/// Error   of straight edges 2^-50 of the coordinates within 2^16 pixels of the film, and beside it; of longer ones,
///         which are anchored near the film, of the film's size. Of curves 2^-48 of the sizes of
///         centre, u and v, measured across the edge.
struct ScanEdge {
  double x_top, y_top, x_bottom, y_bottom;
  double x_ref, y_ref;    ///< point on the line
  double slope, inverse;  ///< dx / dy and dy / dx
  const EdgeCurve* curve;
  int direction;  ///< +1 where the outline runs from top to bottom

  /// Needs   y, x between the ends.
  double x_at(double y) const;
  double y_at(double x) const;
  /// Whether the point lies on the edge or right of it. Exact for straight edges and for whole
  /// ellipses. Needs y between the ends.
  bool has_on_right(double x, double y) const;
};

/// Edges of regions, with what curves have beside them.
class ScanEdges {
 public:
  /// `film`: the pixels near which long edges are anchored, whatever part of them is drawn.
  explicit ScanEdges(double film_width, double film_height)
      : middle_(0.5 * film_width, 0.5 * film_height) {}

  std::span<const ScanEdge> edges() const { return edges_; }
  /// Drops the edges, but for their curves.
  void drop() { edges_.clear(); }
  void clear() { edges_.clear(), curves_.clear(); }
  void add(const Segment& edge);
  void add(const FillRing& ring);
  void add(const FillArcs& arcs);

 private:
  void add(const EllipseArc& arc);
  EdgeCurve* add_part(const EllipseArc& arc, const MonotoneArc& part);

  Vec2 middle_;
  std::vector<ScanEdge> edges_;
  std::deque<EdgeCurve> curves_;
};

/// Written so that a NaN gives `low`: an infinite slope times nothing.
inline double clamp_to(double v, double low, double high) {
  return v > low ? (v < high ? v : high) : low;
}
inline double clamp_between(double v, double a, double b) {
  return a < b ? clamp_to(v, a, b) : clamp_to(v, b, a);
}

inline double ScanEdge::x_at(double y) const {
  const double x = curve == nullptr ? x_ref + (y - y_ref) * slope : x_ref + curve->x.at(y - y_ref);
  return clamp_between(x, x_top, x_bottom);
}
inline double ScanEdge::y_at(double x) const {
  if (x == x_top) return y_top;
  if (x == x_bottom) return y_bottom;
  const double y =
      curve == nullptr ? y_ref + (x - x_ref) * inverse : y_ref + curve->y.at(x - x_ref);
  return clamp_to(y, y_top, y_bottom);
}
}  // namespace flatray
