#include <iterator>

#include "base/check.h"
#include "flatray/status.h"

namespace flatray::api {

const char* words(Fault fault) {
  static constexpr const char* kWords[] = {
      "nothing is wrong",
      "arrays that go together differ in length",
      "a coordinate is NaN or infinite, or a limit of t is NaN",
      "a radius is negative",
      ("an ellipse has no area, an arc no radius or no extent, a curve lies on a line, or a weight "
       "is not from 2^-40 to 2^40"),
      "a polygon has no vertex",
      "a polygon is not convex at this vertex",
      "there is no wall or body of this number",
      "a direction is zero where a ray must lead somewhere",
      "there are more walls or bodies than numbers for them"};
  static_assert(std::size(kWords) == static_cast<std::size_t>(Fault::full) + 1);
  const auto index = static_cast<std::size_t>(fault);
  FLATRAY_CHECK(index < std::size(kWords));
  return kWords[index];
}

}  // namespace flatray::api
