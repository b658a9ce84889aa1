#include "render/pass.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "render/gradient.h"

namespace flatray {

#define FLATRAY_ENTRY(name) extern const Pass name##_pass;
#include "passes.inc"
#undef FLATRAY_ENTRY

std::vector<const Pass*> passes() {
  return {
#define FLATRAY_ENTRY(name) &name##_pass,
#include "passes.inc"
#undef FLATRAY_ENTRY
  };
}

DrawContext::DrawContext(const Scene& scene_, const FrameState& state_)
    : scene(scene_), state(state_), film_from_world(scene_.film, state_) {}

const World& DrawContext::world() {
  if (!world_) world_ = build_world(scene, state);
  return *world_;
}

void DrawContext::place(int layer, std::uint64_t order) {
  layer_ = layer;
  order_ = order;
}

void DrawContext::add(DrawItem&& item) { items_.push_back({layer_, order_, std::move(item)}); }

std::vector<DrawItem> DrawContext::sorted_items() && {
  // Numbers are sorted, not items: g++ 12 takes the swap of a variant for a use before set.
  std::vector<std::size_t> order(items_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
    return std::tie(items_[a].layer, items_[a].order) < std::tie(items_[b].layer, items_[b].order);
  });
  std::vector<DrawItem> items;
  items.reserve(items_.size());
  for (const std::size_t i : order) items.push_back(std::move(items_[i].item));
  return items;
}

double DrawContext::half_width_px(const Stroke& stroke) const {
  return 0.5 * (stroke.in_pixels ? stroke.width : film_from_world.length(stroke.width));
}

LineLook DrawContext::look_of(const Stroke& stroke) const {
  LineLook look{{half_width_px(stroke), stroke.joins, stroke.caps, stroke.miter_limit}, {}, 0};
  if (stroke.dashes == kNoEntry) return look;
  const auto length = [&](double d) { return stroke.in_pixels ? d : film_from_world.length(d); };
  for (const double d : scene.dashes[stroke.dashes]) look.dashes.push_back(length(d));
  look.dash_offset = length(stroke.dash_offset);
  return look;
}

void DrawContext::add_regions(std::vector<Region>&& regions, const Paint& paint,
                              const Pose& place) {
  DrawItem item;
  item.colour = linear(paint);
  if (paint.gradient != kNoEntry) {
    item.gradient = film_gradient(scene.gradients[paint.gradient], place, film_from_world);
    item.colour = summary(*item.gradient);
  }
  for (Region& region : regions) {
    item.region = std::move(region);
    add(DrawItem(item));
  }
}

void DrawContext::add_shape(const Shape& shape, const Pose& world_from_shape,
                            const std::optional<Paint>& fill, const std::optional<Stroke>& stroke) {
  const FilmShape there = film_shape(shape, world_from_shape, film_from_world);
  if (fill) add_regions(fill_regions(there), *fill, world_from_shape);
  if (stroke) add_regions(line_regions(there, look_of(*stroke)), stroke->colour, world_from_shape);
}

void DrawContext::add_lines(std::span<const Segment> world, const Stroke& stroke) {
  FilmShape lines;
  for (const Segment& line : world)
    lines.segments.push_back({film_from_world(line.a), film_from_world(line.b)});
  add_regions(line_regions(lines, look_of(stroke)), stroke.colour, world_pose(state));
}

void DrawContext::add_mark(const Vec2& world, double radius_px, const Colour& colour) {
  add({FillRing{film_from_world(world), radius_px}, linear(colour)});
}

// One item fades by its own colours.
void DrawContext::fade_from(std::size_t first, float opacity) {
  if (items_.size() == first + 1) {
    DrawItem& item = items_.back().item;
    item.colour.a *= opacity;
    if (item.gradient)
      for (FilmGradient::Stop& stop : item.gradient->stops) stop.colour.a *= opacity;
    return;
  }
  ++layers_;
  for (std::size_t i = first; i < items_.size(); ++i) {
    items_[i].item.layer = layers_;
    items_[i].item.opacity = opacity;
  }
}

}  // namespace flatray
