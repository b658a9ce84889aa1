#pragma once
#include <algorithm>
#include <vector>

#include "geom/primitives/wall.h"

namespace flatray {

/// Where a ray meets a curve, in the order of t.
inline std::vector<WallMeeting> meetings(const Bezier& wall, const Ray& ray,
                                         const MeetingRules& rules = {Root::none, true, true}) {
  std::vector<WallMeeting> met;
  meet(wall, ray, rules, met);
  std::sort(met.begin(), met.end(),
            [](const WallMeeting& a, const WallMeeting& b) { return compare(a.time, b.time) < 0; });
  return met;
}

}  // namespace flatray
