#include "render/pass.h"

namespace flatray::contacts_pass {
namespace {

// Of the widths of the lines drawn.
constexpr double kPointRadius = 2.5;  // px
constexpr double kNormalWidths = 16;  // how long
constexpr double kTickWidths = 4;     // to either side of the bar
constexpr double kNowWidths = 3;      // radius of the mark of the time it is
constexpr double kBarMargin = 0.05;   // of the window, to its left, right and below

Need need(const Scene& scene) {
  const auto& asked = scene.collisions;
  if (!asked || !(asked->points || asked->normals || asked->ghosts || asked->time_bar))
    return skip("nothing is drawn of contacts");
  std::string what;
  const auto add = [&](bool has, const char* name) {
    if (has) what += (what.empty() ? "" : ", ") + std::string(name);
  };
  add(asked->points.has_value(), "points");
  add(asked->normals.has_value(), "normals");
  add(asked->ghosts.has_value(), "ghosts");
  add(asked->time_bar.has_value(), "a time bar");
  return run(what);
}

// Both bodies where they were when they met: what responds keeps its outline and its angle.
void add_ghosts(DrawContext& context, const CollisionEvent& event, const Stroke& stroke) {
  for (const std::uint32_t i : {event.a, event.b}) {
    const EntityState& now = context.state.entities[i];
    const Vec2 at = held(place_at(context.timeline.stages(i), event.time));
    context.add_shape(context.scene.shapes[now.shape],
                      pose(at + context.state.displaced, now.angle, now.scale), std::nullopt,
                      stroke);
  }
}

void add_event(DrawContext& context, const Collisions& asked, const CollisionEvent& event) {
  if (asked.ghosts) add_ghosts(context, event, *asked.ghosts);
  const Vec2 point = world_pose(context.state)(event.point);
  if (asked.normals) {
    const double length = 2 * context.half_width_px(*asked.normals) * kNormalWidths /
                          context.film_from_world.length(1);
    const Segment line{point, point + length * event.normal};
    context.add_lines(std::span(&line, 1), *asked.normals);
  }
  if (asked.points) context.add_mark(point, kPointRadius, *asked.points);
}

// Ticks of events that fall into one pixel are one.
void add_time_bar(DrawContext& context, const Stroke& stroke) {
  const double whole = (context.scene.frames - 1) / context.scene.fps;
  if (!(whole > 0)) return;
  const Bounds& window = context.state.window;
  const double width_px = 2 * context.half_width_px(stroke),
               pixel = 1 / context.film_from_world.length(1);
  const Vec2 margin = kBarMargin * window.size();
  const Vec2 from = window.low + margin;
  const double length = window.size().x() - 2 * margin.x();
  const auto at = [&](double time) {
    return Vec2(from.x() + std::min(time / whole, 1.0) * length, from.y());
  };
  std::vector<Segment> lines{{at(0), at(whole)}};
  double last = -kInfinity;
  for (const CollisionEvent& event : context.timeline.events()) {
    if (event.time > whole) break;
    const Vec2 there = at(event.time), up(0, kTickWidths * width_px * pixel);
    if (there.x() < last + pixel) continue;
    last = there.x();
    lines.push_back({there - up, there + up});
  }
  context.add_lines(lines, stroke);
  context.add_mark(at(context.state.time), kNowWidths * width_px, stroke.colour);
}

void draw(DrawContext& context) {
  if (!context.scene.collisions) return;
  const Collisions& asked = *context.scene.collisions;
  context.place(asked.layer, asked.order, asked.where);
  if (asked.points || asked.normals || asked.ghosts)
    for (const CollisionEvent& event : context.timeline.events()) {
      const double age = context.state.time - event.time;
      if (age < 0 || context.refused()) break;
      const double left = asked.shown ? 1 - age / *asked.shown : 1;
      if (left > 0) context.fade(left, [&] { add_event(context, asked, event); });
    }
  if (asked.time_bar) add_time_bar(context, *asked.time_bar);
}

}  // namespace

extern const Pass entry = {"contacts", &need, &draw};

}  // namespace flatray::contacts_pass
