#include "render/coverage/bands.h"

#include <algorithm>
#include <cmath>

#include "image/band_rows.h"

namespace flatray {
namespace {

constexpr std::size_t kFewEdges =
    48;  // looking at all of them costs less than sorting them by band

// An edge on the border of two columns is in both.
Bounds region_bounds(const FillPath& path) {
  Bounds bounds;
  for (const Segment& edge : path.edges) bounds.add(edge.a), bounds.add(edge.b);
  bounds.high.x() = std::nextafter(bounds.high.x(), kInfinity);
  return bounds;
}

// For rounding: a pixel, and more for what goes far beyond the film.
double margin(const Vec2& sizes) { return std::max(1.0, 0x1p-46 * sizes.maxCoeff()); }

Bounds region_bounds(const FillRing& ring) {
  const double room = margin(ring.centre.cwiseAbs() + Vec2::Constant(ring.radius));
  const Vec2 reach = Vec2::Constant(ring.radius + room);
  return {ring.centre - reach, ring.centre + reach};
}

Bounds region_bounds(const FillArcs& arcs) {
  const Bounds bounds = path_bounds(arcs.path);
  Vec2 sizes(0, 0);
  for (const EllipseArc& arc : arcs.path.arcs)
    sizes = sizes.cwiseMax(arc.centre.cwiseAbs() + arc.u.cwiseAbs() + arc.v.cwiseAbs());
  const Vec2 room = Vec2::Constant(margin(sizes));
  return {bounds.low - room, bounds.high + room};
}

bool same(const std::shared_ptr<const LightPicture>& a,
          const std::shared_ptr<const LightPicture>& b) {
  return a == b || (a != nullptr && b != nullptr && a->rgb == b->rgb);
}

// By numbers: no picture tells -0 from 0.
bool same(const DrawItem& a, const DrawItem& b) {
  return same(a.light, b.light) && a.colour == b.colour && a.layer == b.layer &&
         a.opacity == b.opacity && a.gradient == b.gradient && a.region == b.region;
}

BandChange columns_of(const Bounds& bounds, const PixelBox& box) {
  if (bounds.empty()) return {};
  const auto within = [&](double x) {
    return static_cast<int>(std::clamp<double>(x, box.x, box.right()));
  };
  return {within(std::floor(bounds.low.x())), within(std::ceil(bounds.high.x()))};
}

// Whether an item of one list is as one of another: kept, as it may lie in many bands.
struct ItemComparison {
  std::size_t before = ~std::size_t{0};
  bool same = false;
};

}  // namespace

std::span<const std::uint32_t> Band::edges(const BandItem& item) const {
  const auto begin = std::lower_bound(edges_.begin(), edges_.end(), item.first);
  const auto end = std::lower_bound(begin, edges_.end(), item.first + item.edges);
  return {begin, end};
}

Bands::Bands(const DrawList& list, const PixelBox& crop)
    : crop_(crop),
      rows_(tile_rows(crop.width)),
      count_(static_cast<std::size_t>((crop.height + rows_ - 1) / rows_)),
      items_of_(count_),
      edges_of_(count_) {
  for (std::size_t i = 0; i < list.items.size(); ++i) add(i, list.items[i]);
}

PixelBox Bands::box(std::size_t band) const {
  const int top = static_cast<int>(band) * rows_;
  return {crop_.x, crop_.y + top, crop_.width, std::min(rows_, crop_.height - top)};
}

void Bands::list(std::size_t band, Band& out) const {
  out.all_ = items_.data();
  items_of_.list(band, out.items_);
  edges_of_.list(band, out.edges_);
}

void Bands::add(std::size_t index, const DrawItem& item) {
  const FillPath* path = std::get_if<FillPath>(&item.region);
  const Bounds bounds =
      std::visit([](const auto& region) { return region_bounds(region); }, item.region);
  if (item.colour.a == 0 || bounds.empty() || bounds.high.x() <= crop_.x ||
      bounds.low.x() >= crop_.right() || bounds.high.y() <= crop_.y ||
      bounds.low.y() >= crop_.bottom())
    return;
  BandItem entry;
  entry.item = static_cast<std::uint32_t>(index);
  entry.bounds = bounds;
  if (path != nullptr && path->edges.size() > kFewEdges) {
    entry.first = edges_;
    entry.edges = static_cast<std::uint32_t>(path->edges.size());
    add_edges(*path);
  }
  items_of_.add(static_cast<std::uint32_t>(items_.size()), band_of(bounds.low.y()),
                band_of(bounds.high.y()));
  items_.push_back(entry);
}

void Bands::add_edges(const FillPath& path) {
  for (const Segment& edge : path.edges) {
    const auto [low, high] = std::minmax(edge.a.y(), edge.b.y());
    const std::uint32_t number = edges_++;
    if (high < crop_.y || low > crop_.y + crop_.height) continue;
    edges_of_.add(number, band_of(low), band_of(high));
  }
}

std::size_t Bands::band_of(double y) const {
  const double row = std::clamp<double>(std::floor(y) - crop_.y, 0, crop_.height - 1);
  return static_cast<std::size_t>(row) / static_cast<std::size_t>(rows_);
}

std::vector<BandChange> whole_bands(const Bands& bands) {
  const PixelBox box = bands.box(0);
  return std::vector<BandChange>(bands.count(), BandChange{box.x, box.right()});
}

// Of the items that stand between those that both lists have from the lowest up and from the
// uppermost down.
std::vector<BandChange> compare_bands(const DrawList& now, const Bands& now_bands,
                                      const DrawList& before, const Bands& before_bands) {
  std::vector<BandChange> changes = whole_bands(now_bands);
  if (now.width != before.width || now.height != before.height || now.coverage != before.coverage ||
      now.rows != before.rows || now.crowd != before.crowd || now.background != before.background ||
      now_bands.count() != before_bands.count())
    return changes;
  std::vector<ItemComparison> compared(now.items.size());
  Band shown, kept;
  for (std::size_t band = 0; band < changes.size(); ++band) {
    now_bands.list(band, shown);
    before_bands.list(band, kept);
    const std::size_t both = std::min(shown.size(), kept.size());
    const auto alike = [&](std::size_t i, std::size_t k) {
      const std::size_t one = shown[i].item, other = kept[k].item;
      ItemComparison& last = compared[one];
      if (last.before != other) last = {other, same(now.items[one], before.items[other])};
      return last.same;
    };
    std::size_t below = 0, above = 0;
    while (below < both && alike(below, below)) ++below;
    while (above < both - below && alike(shown.size() - 1 - above, kept.size() - 1 - above))
      ++above;
    Bounds changed;
    for (std::size_t i = below; i < shown.size() - above; ++i) changed.add(shown[i].bounds);
    for (std::size_t i = below; i < kept.size() - above; ++i) changed.add(kept[i].bounds);
    changes[band] = columns_of(changed, now_bands.box(band));
  }
  return changes;
}

}  // namespace flatray
