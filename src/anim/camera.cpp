#include "anim/camera.h"

#include "anim/rays.h"
#include "scene/curve.h"

namespace flatray {
namespace {

constexpr double kContentMargin = 0.05;  // of the content's size, on each side

double world_width(const std::optional<Stroke>& stroke) {
  return stroke && !stroke->in_pixels ? stroke->scale * stroke->width : 0;
}

// A box with a margin; what has no size gets one that its position can carry.
Bounds with_margin(const Bounds& content) {
  if (content.empty()) return {{0, 0}, {1, 1}};
  Vec2 reach = kContentMargin * content.size();
  if (content.size().isZero(0)) {
    const double half = std::max(0.5, content.low.cwiseAbs().maxCoeff() * 0x1p-20);
    reach = {half, half};
  }
  return {content.low - reach, content.high + reach};
}

// The smallest box of the film's aspect with the same centre that holds `box`; the side that fits
// keeps its bits.
Bounds grown_to_aspect(Bounds box, const Film& film) {
  const Vec2 size = box.size(), centre = box.centre();
  const double width = film.width, height = film.height;
  if (size.x() * height < size.y() * width) {
    const double reach = 0.5 * (size.y() * width / height);
    box.low.x() = centre.x() - reach;
    box.high.x() = centre.x() + reach;
  } else if (size.x() * height > size.y() * width) {
    const double reach = 0.5 * (size.x() * height / width);
    box.low.y() = centre.y() - reach;
    box.high.y() = centre.y() + reach;
  }
  return box;
}

Bounds centred(const Vec2& centre, const Vec2& size) {
  const Vec2 low = centre - 0.5 * size;
  return {low, low + size};
}

// A window before it follows or drifts. Its size is not that between its corners, which round it.
struct Framed {
  Bounds box;
  Vec2 size;
};
Framed framed(const Timeline& timeline, double time) {
  const Scene& scene = timeline.scene();
  const Film& film = scene.film;
  const Camera& camera = scene.camera;
  const Bounds wanted = film.world ? *film.world : with_margin(timeline.content());
  const Bounds box = grown_to_aspect(wanted, film);
  const Vec2 centre = camera.at ? plus(scene, *camera.at, time) : wanted.centre();
  Vec2 size = box.size();
  if (camera.height) {
    const double height = plus(scene, *camera.height, time);
    size = {height * film.width / film.height, height};
  }
  const double zoom = plus(scene, camera.zoom, time);
  if (!camera.at && !camera.height && zoom == 1) return {box, size};
  size /= zoom;
  return {centred(centre, size), size};
}

}  // namespace

Bounds content_bounds(const Scene& scene, const std::vector<EntityState>& entities) {
  Bounds all;
  // A shape with the outer half of its stroke.
  const auto add = [&](const Shape& shape, const Pose& place, double stroke) {
    const Bounds box = shape_extent(shape, place);
    const Vec2 reach(stroke / 2, stroke / 2);
    if (!box.empty()) all.add(Bounds{box.low - reach, box.high + reach});
  };
  for (std::size_t i = 0; i < entities.size(); ++i) {
    const EntityState& entity = entities[i];
    const double stroke = std::max(world_width(entity.stroke),
                                   entity.scale * world_width(scene.entities[i].bounding_box));
    add(shape_of(scene, entity), pose(entity.at, entity.angle, entity.scale), stroke);
  }
  for (const Chamber& chamber : scene.chambers) {
    add(scene.shapes[chamber.shape], {Vec2(0, 0)}, world_width(chamber.stroke));
    for (const Chamber::Pillar& pillar : chamber.pillars)
      add(scene.shapes[pillar.shape], pose(pillar.at, pillar.angle), world_width(pillar.stroke));
  }
  for (const RayState& ray : ray_states(scene, 0)) all.add(ray.start.origin);
  for (const Lamp& lamp : scene.lamps) all.add(lamp.at);
  return all;
}

bool is_window_of_content(const Scene& scene) {
  const Camera& camera = scene.camera;
  return !scene.film.world && !(camera.height && (camera.at || camera.follow));
}

Bounds camera_window(const Timeline& timeline, double time, const Vec2& followed) {
  const Camera& camera = timeline.scene().camera;
  const auto [still, size] = framed(timeline, time);
  Vec2 low = camera.follow ? followed + camera.offset - 0.5 * size : still.low;
  low += camera.velocity * time;
  if (low == still.low) return still;
  return {low, low + size};
}

}  // namespace flatray
