#include "render/gl/batches.h"

#include <algorithm>
#include <array>

#include "geom/polygon.h"
#include "render/coverage/chains.h"
#include "render/gl/grid.h"
#include "render/gl/outlines.h"

namespace flatray::gl {
namespace {

// Beyond the tile nothing is drawn, and corners farther out than the rasterizer takes are cut off.
constexpr double kGuard = 512;
// A stencil counts modulo 256.
constexpr std::size_t kMostWindings = 255;

// What a vertex has besides its place: FlatrayGlVertex::paint.
struct VertexPaint {
  std::array<float, 4> words;
  bool gradient = false;
};

FlatrayGlVertex vertex(const GridPoint& point, const VertexPaint& paint) {
  const auto pixels = [](std::int64_t steps) {
    return static_cast<float>(static_cast<double>(steps) / kGridSteps);
  };
  const auto& [a, b, c, d] = paint.words;
  return {pixels(point.x), pixels(point.y), {a, b, c, d}};
}

// Makes batches of items, in their order: figures that are painted one after another share one.
class BatchList {
 public:
  BatchList(int width, int height) : size_(width, height) {}

  // A convex figure that is blended as it is.
  void paint(std::span<const GridPoint> corners, const VertexPaint& paint) {
    const Bounds pixels = pixels_about(corners);
    if (pixels.empty()) return;
    reach_.add(pixels);
    begin(FLATRAY_GL_PAINT, paint);
    add_fan(corners, paint);
  }

  // An item that is marked first and then covered: triangles from the first point of each figure
  // to every edge of it, as marks of `kind`.
  void mark(FlatrayGlKind kind, std::span<const std::vector<GridPoint>> figures,
            const VertexPaint& paint) {
    Bounds pixels;
    for (const std::vector<GridPoint>& figure : figures) pixels.add(pixels_about(figure));
    if (pixels.empty()) return;
    reach_.add(pixels);
    begin(kind, {});
    for (const std::vector<GridPoint>& figure : figures) add_fan(figure, {});
    if (kind == FLATRAY_GL_SUM) add_box(FLATRAY_GL_FIND, pixels, {});
    add_box(FLATRAY_GL_COVER, pixels, paint);
  }

  // What another list drew of the tile, as one picture, faded.
  void lay(const BatchList& layer, float opacity) {
    const Bounds& pixels = layer.reach_;
    if (pixels.empty()) return;
    reach_.add(pixels);
    add_box(FLATRAY_GL_LAYER, pixels, {});
    const auto first = static_cast<std::uint32_t>(all_.vertices.size());
    for (FlatrayGlBatch batch : layer.all_.batches) {
      batch.first += first;
      all_.batches.push_back(batch);
    }
    all_.vertices.insert(all_.vertices.end(), layer.all_.vertices.begin(),
                         layer.all_.vertices.end());
    add_box(FLATRAY_GL_LAY, pixels, {{opacity}});
  }

  Batches finish() && { return std::move(all_); }

 private:
  // Pixels a figure can touch, with a pixel around it for the shifts of its samples.
  Bounds pixels_about(std::span<const GridPoint> points) const {
    Bounds steps;
    for (const GridPoint& p : points)
      steps.add({static_cast<double>(p.x), static_cast<double>(p.y)});
    const Vec2 low((steps.low / kGridSteps).array().floor() - 1.0);
    const Vec2 high((steps.high / kGridSteps).array().floor() + 2.0);
    return {low.cwiseMax(0.0), high.cwiseMin(size_)};
  }

  // A batch of its own, unless the last is painted likewise.
  void begin(FlatrayGlKind kind, const VertexPaint& paint) {
    const std::int32_t gradients = paint.gradient ? 1 : 0;
    const bool goes_on = kind == FLATRAY_GL_PAINT && !all_.batches.empty() &&
                         all_.batches.back().kind == kind &&
                         all_.batches.back().gradients == gradients;
    if (goes_on) return;
    all_.batches.push_back({kind, gradients, static_cast<std::uint32_t>(all_.vertices.size()), 0});
  }

  void add_fan(std::span<const GridPoint> corners, const VertexPaint& paint) {
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      if (area(corners[0], corners[i], corners[i + 1]) == 0) continue;
      for (const GridPoint& corner : {corners[0], corners[i], corners[i + 1]})
        all_.vertices.push_back(vertex(corner, paint));
      all_.batches.back().count += 3;
    }
  }

  void add_box(FlatrayGlKind kind, const Bounds& pixels, const VertexPaint& paint) {
    begin(kind, paint);
    const GridPoint low = on_grid(pixels.low), high = on_grid(pixels.high);
    add_fan(std::array{low, GridPoint{high.x, low.y}, high, GridPoint{low.x, high.y}}, paint);
  }

  Vec2 size_;
  Bounds reach_;  // whole pixels about all there is
  Batches all_;
};

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
    if (!opaque_) return wind(figures(rings, true), false);
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

  std::vector<Grid> figures(const std::vector<Ring>& rings, bool convex_ones = false) const {
    std::vector<Grid> figures;
    for (const Ring& ring : rings)
      figures.push_back(convex_ones ? convex(ring) : on_grid(clamped(ring, guard_)));
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
