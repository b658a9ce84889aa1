#include "base/check.h"
#include "flatray/status.h"

namespace flatray::api {

const char* words(Fault fault) {
  switch (fault) {
    case Fault::none:
      return "nothing is wrong";
    case Fault::sizes:
      return "arrays that go together differ in length";
    case Fault::not_finite:
      return "a coordinate is NaN or infinite, or a limit of t is NaN";
    case Fault::radius:
      return "a radius is negative";
    case Fault::degenerate:
      return "an ellipse has no area, or an arc no radius or no extent";
    case Fault::empty:
      return "a polygon has no vertex";
    case Fault::not_convex:
      return "a polygon is not convex at this vertex";
    case Fault::no_such:
      return "there is no wall or body of this number";
    case Fault::direction:
      return "a direction is zero where a ray must lead somewhere";
    case Fault::full:
      return "there are more walls or bodies than numbers for them";
  }
  unreachable();
}

}  // namespace flatray::api
