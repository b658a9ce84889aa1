#pragma once
#include "image/srgb.h"
#include "polygons.h"
#include "render/frame.h"

namespace bench {

/// The polygons as flatray draws them: opaque, on white.
inline flatray::DrawList draw_list(const std::vector<Polygon>& polygons, int width, int height,
                                   flatray::Coverage coverage) {
  flatray::DrawList list;
  list.width = width, list.height = height;
  list.background = {1, 1, 1, 1};
  list.coverage = coverage;
  for (const Polygon& polygon : polygons) {
    flatray::FillPath path;
    path.simple = true;
    const auto& corners = polygon.corners;
    path.edges.reserve(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i)
      path.edges.push_back({corners[i], corners[(i + 1) % corners.size()]});
    const auto& [r, g, b] = polygon.colour;
    flatray::DrawItem item;
    item.region = std::move(path);
    item.colour = {flatray::linear_from_srgb(r), flatray::linear_from_srgb(g),
                   flatray::linear_from_srgb(b), 1};
    list.items.push_back(std::move(item));
  }
  return list;
}

}  // namespace bench
