#pragma once
#include <vector>

#include "trace/surfaces.h"

namespace flatray {

/// Straight walls from corner to corner, and from the last to the first.
inline Surfaces room(const std::vector<Vec2>& corners) {
  Surfaces walls;
  for (std::size_t i = 0; i < corners.size(); ++i)
    walls.add(Segment{corners[i], corners[(i + 1) % corners.size()]});
  return walls;
}

}  // namespace flatray
