#include "render/pass.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "base/counted.h"
#include "geom/polygon.h"
#include "render/gradient.h"

namespace flatray {

#include "passes.inc"  // passes()

namespace {

std::uint64_t corner_count(std::span<const Region> regions) {
  std::uint64_t count = 0;
  for (const Region& region : regions) {
    if (const auto* path = std::get_if<FillPath>(&region)) count += path->edges.size();
    if (const auto* arcs = std::get_if<FillArcs>(&region)) count += 4 * arcs->path.arcs.size();
  }
  return count;
}

// A way that comes round to the same lines draws them again and again. What it draws is the same without
// whole rounds before its last line, as long as each line follows once on the one before it.
std::vector<Segment> without_rounds(std::span<const Segment> way) {
  std::vector<Segment> once(way.begin(), way.end());
  const std::size_t size = way.empty() ? 0 : way.size() - 1;  // the last may be cut short
  const auto is_same = [&](std::size_t i, std::size_t k) {
    return way[i].a == way[k].a && way[i].b == way[k].b;
  };
  std::size_t round = 1, repeated = 0;  // lines of one, lines that are as those a round before
  while (round < size && !is_same(size - 1, size - 1 - round)) ++round;
  while (repeated + round < size && is_same(size - 1 - repeated, size - 1 - repeated - round))
    ++repeated;
  if (repeated <= round) return once;
  const auto last = once.begin() + static_cast<std::ptrdiff_t>(size);
  once.erase(last - static_cast<std::ptrdiff_t>((repeated - 1) / round * round), last);
  return once;
}

}  // namespace

DrawContext::DrawContext(const Timeline& timeline_, const FrameState& state_, const Tracer* tracer_)
    : timeline(timeline_),
      scene(timeline_.scene()),
      state(state_),
      tracer(tracer_),
      film_from_world(scene.film, state_),
      corners_{scene.max_corners} {}

void DrawContext::place(int layer, std::uint64_t order, const Place& where) {
  layer_ = layer;
  order_ = order;
  where_ = where;
}

bool DrawContext::take(std::uint64_t corners) {
  if (!corners_.take(corners) && !refused_) refused_ = where_;
  return !refused_;
}

void DrawContext::add(DrawItem&& item) {
  constexpr std::uint64_t kCornersOfItem = 8;  // about as many bytes
  ++parts_;
  if (take(kCornersOfItem)) items_.push_back({layer_, order_, std::move(item)});
}

void DrawContext::add_light(std::shared_ptr<const LightPicture> picture) {
  const Bounds film{Vec2(0, 0), Vec2(scene.film.width, scene.film.height)};
  DrawItem item;
  item.region = FillPath{ring_edges(film.corners()), FillRule::nonzero, true};
  item.colour = {0, 0, 0, 0.5F};  // neither hides what lies below nor is not seen
  item.light = std::move(picture);
  add(std::move(item));
}

Result<std::vector<DrawItem>> DrawContext::sorted_items() && {
  if (refused_)
    return fail(*refused_,
                "with this a frame draws more than " + counted(scene.max_corners, "corner"),
                "those of lines and dashes count: make dashes longer and wide lines thinner, draw "
                "less, or say --max-corners N");
  // Numbers are sorted, not items: g++ 12 takes the swap of a variant for a use before set.
  std::vector<std::size_t> order(items_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(
      order, {}, [this](std::size_t i) { return std::tie(items_[i].layer, items_[i].order); });
  std::vector<DrawItem> items;
  items.reserve(items_.size());
  for (const std::size_t i : order) items.push_back(std::move(items_[i].item));
  return items;
}

double DrawContext::half_width_px(const Stroke& stroke) const {
  return 0.5 *
         (stroke.in_pixels ? stroke.width : film_from_world.length(stroke.scale * stroke.width));
}

LineLook DrawContext::look_of(const Stroke& stroke) const {
  LineLook look{{half_width_px(stroke), stroke.joins, stroke.caps, stroke.miter_limit}, {}, 0};
  if (stroke.dashes == kNoEntry) return look;
  const auto length = [&](double d) {
    return stroke.in_pixels ? d : film_from_world.length(stroke.scale * d);
  };
  for (const double d : scene.dashes[stroke.dashes]) look.dashes.push_back(length(d));
  look.dash_offset = length(stroke.dash_offset);
  return look;
}

void DrawContext::add_regions(std::vector<Region>&& regions, const Paint& paint,
                              const Pose& place) {
  DrawItem item;
  item.colour = paint.curve == kNoEntry ? linear(paint) : light_at(scene, paint.curve, state.time);
  if (paint.gradient != kNoEntry) {
    item.gradient = film_gradient(scene.gradients[paint.gradient], place, film_from_world);
    item.colour = summary(*item.gradient);
  }
  for (Region& region : regions) {
    item.region = std::move(region);
    add(DrawItem(item));
  }
}

void DrawContext::add_outline(const FilmShape& there, const Stroke& stroke, const Pose& place) {
  std::vector<Region> regions = line_regions(there, look_of(stroke), corners_);
  if (take(0)) add_regions(std::move(regions), stroke.colour, place);
}

void DrawContext::add_shape(const Shape& shape, const Pose& world_from_shape,
                            const std::optional<Paint>& fill, const std::optional<Stroke>& stroke) {
  if (refused()) return;
  const double reach = stroke ? line_reach(look_of(*stroke).style) : 0;
  if (beside_film(shape, world_from_shape, film_from_world, scene.film, reach)) {
    parts_ += std::size_t{fill.has_value()} + std::size_t{stroke.has_value()};
    return;
  }
  const FilmShape there = film_shape(shape, world_from_shape, film_from_world);
  if (fill) {
    std::vector<Region> regions = fill_regions(there);
    if (take(corner_count(regions))) add_regions(std::move(regions), *fill, world_from_shape);
  }
  if (stroke) add_outline(there, *stroke, world_from_shape);
}

void DrawContext::add_lines(std::span<const Segment> world, const Stroke& stroke) {
  if (refused()) return;
  FilmShape lines;
  const bool whole = stroke.dashes == kNoEntry;  // else they lie elsewhere in each round
  for (const Segment& line :
       whole ? without_rounds(world) : std::vector(world.begin(), world.end()))
    lines.segments.push_back({film_from_world(line.a), film_from_world(line.b)});
  add_outline(lines, stroke, world_pose(state));
}

void DrawContext::add_mark(const Vec2& world, double radius_px, const Colour& colour) {
  add({FillRing{film_from_world(world), radius_px}, linear(colour)});
}

// One item fades by its own colours, unless others of the picture lie beside the film: where the
// film ends changes no way of rounding.
void DrawContext::fade_from(std::size_t first, std::size_t parts, float opacity) {
  if (parts == 1) {
    if (items_.size() == first) return;
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
