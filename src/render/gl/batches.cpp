#include "render/gl/batches.h"

#include <algorithm>

#include "geom/polygon.h"
#include "render/coverage/chains.h"
#include "render/gl/batch_list.h"
#include "render/gl/outlines.h"

namespace flatray::gl {
namespace {

// Beyond the tile nothing is drawn, and corners farther out than the rasterizer takes are cut off.
constexpr double kGuard = 512;
// A stencil counts modulo 256.
constexpr std::size_t kMostWindings = 255;

using Grid = std::vector<GridPoint>;

Grid on_grid(const Ring& ring) {
  Grid points;
  points.reserve(ring.size());
  for (const Vec2& point : ring) points.push_back(gl::on_grid(point));
  return points;
}

// All convex and running the same way: a point is in their union where it is in one of them.
bool convex_alike(const std::vector<Ring>& rings) {
  std::optional<Sign> first;
  return std::all_of(rings.begin(), rings.end(), [&](const Ring& ring) {
    if (non_convex_vertex(ring)) return false;
    const Sign way = ring_orientation(ring);
    if (way == Sign::zero) return true;
    if (!first) first = way;
    return way == *first;
  });
}

class Builder {
 public:
  explicit Builder(const PixelBox& tile)
      : tile_(tile), out_(tile.width, tile.height), origin_(tile.x, tile.y) {
    box_ = {Vec2(0, 0), Vec2(tile.width, tile.height)};
    guard_ = {box_.low - Vec2(kGuard, kGuard), box_.high + Vec2(kGuard, kGuard)};
  }

  void add(const DrawItem& item) {
    if (item.colour.a == 0) return;
    paint_ = item.gradient ? paint_of(*item.gradient) : VertexPaint{premultiplied(item.colour)};
    opaque_ = item.colour.a == 1;
    std::visit([&](const auto& region) { add(region); }, item.region);
  }

  /// Items that are faded as one.
  void add_layer(std::span<const DrawItem> items) {
    BatchList layer(tile_.width, tile_.height);
    std::swap(layer, out_);
    for (const DrawItem& item : items) add(item);
    std::swap(layer, out_);
    out_.lay(layer, items.front().opacity);
  }

  Batches finish() && {
    Batches all = std::move(out_).finish();
    all.gradients = std::move(gradients_);
    all.stops = std::move(stops_);
    return all;
  }

 private:
  VertexPaint paint_of(const FilmGradient& gradient) {
    const auto number = static_cast<float>(gradients_.size());  // exact below 2^24
    const auto first = static_cast<std::uint32_t>(stops_.size());
    for (const FilmGradient::Stop& stop : gradient.stops) {
      const auto [r, g, b, a] = premultiplied(stop.colour);
      stops_.push_back({stop.at, 0, {r, g, b, a}});
    }
    const Vec2 axis = gradient.radial ? Vec2(gradient.per_pixel, 0) : gradient.axis;
    gradients_.push_back({gradient.radial ? 1U : 0U,
                          first,
                          static_cast<std::uint32_t>(gradient.stops.size()),
                          0,
                          {gradient.origin.x(), gradient.origin.y()},
                          {axis.x(), axis.y()}});
    return {{number}, true};
  }

  void add(const FillPath& path) {
    std::vector<Ring> rings;
    Bounds reach;
    for (Chain& chain : rings_of(path.edges)) {
      for (Vec2& point : chain.points) reach.add(point -= origin_);
      rings.push_back(std::move(chain.points));
    }
    if (!box_.meets(reach)) return;
    const bool one = rings.size() == 1 && (path.simple || !non_convex_vertex(rings[0]));
    if (one) return paint(rings[0]);
    if (path.rule == FillRule::even_odd) return out_.mark(FLATRAY_GL_FLIP, figures(rings), paint_);
    if (!convex_alike(rings)) return wind(figures(rings), path.simple);
    if (!opaque_) return wind(convex_figures(rings), false);
    for (const Ring& ring : rings) paint(ring);
  }

  void add(const FillRing& ring) {
    const Vec2 centre = ring.centre - origin_, reach(ring.radius, ring.radius);
    if (!(ring.radius > 0) || !box_.meets({centre - reach, centre + reach})) return;
    const Ring outer = circle_ring(centre, ring.radius, guard_);
    if (ring.inner_radius > 0)
      out_.mark(FLATRAY_GL_FLIP, figures({outer, circle_ring(centre, ring.inner_radius, guard_)}),
                paint_);
    else
      paint(outer);
  }

  // A path of arcs that crosses itself nowhere, as chords.
  void add(const FillArcs& region) {
    Ring ring = flattened(region.path, 1 / kGridSteps);
    if (ring.size() < 4) return;
    ring.pop_back();  // the first again
    for (Vec2& point : ring) point -= origin_;
    if (!box_.meets(box_about(ring))) return;
    if (non_convex_vertex(ring))
      out_.mark(FLATRAY_GL_FLIP, figures({ring}), paint_);
    else
      paint(ring);
  }

  // A convex ring.
  void paint(const Ring& ring) {
    const Grid corners = convex(ring);
    if (!corners.empty()) out_.paint(corners, paint_);
  }

  Grid convex(const Ring& ring) const { return hull(on_grid(clipped(ring, guard_))); }

  std::vector<Grid> convex_figures(const std::vector<Ring>& rings) const {
    std::vector<Grid> figures;
    for (const Ring& ring : rings) figures.push_back(convex(ring));
    return figures;
  }

  std::vector<Grid> figures(const std::vector<Ring>& rings) const {
    std::vector<Grid> figures;
    for (const Ring& ring : rings) figures.push_back(on_grid(clamped(ring, guard_)));
    return figures;
  }

  void wind(const std::vector<Grid>& figures, bool simple) {
    const bool few = simple || most_windings(figures, kMostWindings) <= kMostWindings;
    out_.mark(few ? FLATRAY_GL_COUNT : FLATRAY_GL_SUM, figures, paint_);
  }

  const PixelBox tile_;
  BatchList out_;
  Vec2 origin_;
  Bounds box_, guard_;
  VertexPaint paint_;  // of the item
  bool opaque_ = false;
  std::vector<FlatrayGlGradient> gradients_;
  std::vector<FlatrayGlStop> stops_;
};

}  // namespace

Batches batches(const DrawList& list, const PixelBox& tile) {
  Builder builder(tile);
  const std::span<const DrawItem> items = list.items;
  for (std::size_t i = 0, end; i < items.size(); i = end) {
    end = i + 1;
    const std::uint32_t layer = items[i].layer;
    while (layer != 0 && end < items.size() && items[end].layer == layer) ++end;
    if (layer == 0)
      builder.add(items[i]);
    else
      builder.add_layer(items.subspan(i, end - i));
  }
  return std::move(builder).finish();
}

}  // namespace flatray::gl
