#pragma once
#include "geom/ellipse.h"

namespace flatray {

/// A straight or elliptical edge on which x and y each only rise or only fall, from its upper to
/// its lower end, ready to be cut by rows and columns of pixels.
///
/// With half-diameters u, v an ellipse is the x-shear of one along the axes: at the height d over
/// its centre x = k d +- w sqrt(1 - (d / h)^2), where h^2 = u.y^2 + v.y^2,
/// k = (u.x u.y + v.x v.y) / h^2 and w = |u x v| / h; likewise the other way round.
///
/// Error   points are within 2^-48 of the sizes of centre, u and v from the arc they are meant to
///         be on, measured across it.
class ArcEdge {
 public:
  ArcEdge(const Vec2& a, const Vec2& b);
  /// Needs   a part of the arc.
  ArcEdge(const EllipseArc& arc, const MonotoneArc& part);

  double x_top, y_top, x_bottom, y_bottom;
  int direction;  ///< +1 where the path runs from top to bottom

  /// Needs   y, x between the ends.
  double x_at(double y) const;
  double y_at(double x) const;
  /// Area between a chord of the edge and the edge, which it has more on its right: from one point
  /// of it to another, by their difference.
  double bow(const Vec2& chord) const;

 private:
  // One coordinate by the other: x = centre + shear d + reach sqrt(1 - (d / half)^2).
  struct Branch {
    double centre = 0, shear = 0, reach = 0, half = 0;
    double at(double d) const;
  };

  bool straight_ = true;
  Vec2 centre_{0, 0}, u_{0, 0}, v_{0, 0};
  Branch x_, y_;
  double det_ = 0, side_ = 0;
};

}  // namespace flatray
