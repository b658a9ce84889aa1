#include "scene/part_counts.h"

#include <algorithm>

namespace flatray {

PartCounts part_counts(const Shape& shape) {
  const auto closed = static_cast<std::size_t>(
      std::ranges::count_if(shape.arc_paths, [](const ArcPath& path) { return path.closed; }));
  return {shape.piece_count(),   shape.crossing_rings.size(),     shape.circles.size(), closed,
          shape.segments.size(), shape.arc_paths.size() - closed, shape.beziers.size()};
}

}  // namespace flatray
