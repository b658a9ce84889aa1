#pragma once
#include <vector>

#include "oracle/families.h"

namespace flatray::oracle {

/// Curves by their control points, and rays aimed at what is hard about them.
struct BezierScene {
  std::vector<std::vector<Vec2>> curves;  ///< of three or four points each, not all on one line
  std::vector<Ray> rays;
};

/// Parabolas and cubics of whole control points, with loops, cusps and inflections that doubles hold:
/// rays through whole points, ends, double points; tangents, those of inflections too; rays within an
/// ulp of all of these.
BezierScene beziers(Draw& draw);
/// The same in units of 2^-900 to 2^899, moved by 2^10 to 2^29, flattened by up to 2^-299.
BezierScene bezier_scaled(Draw& draw);
BezierScene bezier_offset(Draw& draw);
BezierScene bezier_sliver(Draw& draw);
/// Of random doubles.
BezierScene bezier_random(Draw& draw);

}  // namespace flatray::oracle
