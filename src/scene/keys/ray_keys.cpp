#include <algorithm>

#include "base/counted.h"
#include "scene/keys/copies.h"
#include "scene/keys/look_keys.h"
#include "scene/keys/motion_keys.h"
#include "scene/keys/scene_keys.h"
#include "scene/moving_mirrors.h"

namespace flatray {
namespace {

constexpr Colour kRed{0xd6, 0x27, 0x28, 255}, kGreen{0x2c, 0xa0, 0x2c, 255},
    kBlue{0x1f, 0x77, 0xb4, 255}, kGrey{0x7f, 0x7f, 0x7f, 255};
constexpr std::int64_t kMaxBounces = 100'000;
constexpr std::int64_t kMaxFan = 10'000;

template <class Rays>
void change_stroke(Builder& builder, const Field& field, Rays& rays) {
  read_stroke(builder, field, rays.stroke);
}

void read_direction(Builder& builder, const Field& field, RayPath& ray) {
  const std::optional<MovingPoint> direction = read_moving_point(builder, field);
  if (!direction) return;
  const Scene& scene = builder.scene;
  if (lies_between(scene, {direction->value.x(), direction->x}, 0, 0) &&
      lies_between(scene, {direction->value.y(), direction->y}, 0, 0))
    return builder.in.problem(field, "has no length", "write where the ray goes, at any length");
  ray.direction = *direction;
}

constexpr NumberRule kSpeedRule{[](double speed) { return speed > 0 && speed < kFarthest; },
                                "must be above 0 and below 1e+300", "write 1"};

template <auto Pointer, double (*change)(double) = nullptr>
void set_moving(Builder& builder, const Field& field, OwnerOf<Pointer>& target) {
  if (const std::optional<Moving> number = read_moving(builder, field, change))
    target.*Pointer = *number;
}

constexpr Key<RayPath::Fan> kFanKeys[] = {
    {{"count", "whole number", kRequired}, &set_integer<&RayPath::Fan::count, 1, kMaxFan>},
    {{"spread", "degrees or a curve", "0"}, &set_moving<&RayPath::Fan::spread, &radians>},
    {{"width", "number or a curve", "0"}, &set_moving<&RayPath::Fan::width>},
};

void read_fan(Builder& builder, const Field& field, RayPath& ray) {
  RayPath::Fan fan;
  read_keys(builder, field.value, "ray.fan", kFanKeys, fan);
  ray.fan = fan;
}

// The rays of a fan from the first to the last, to the left; the middle one of an odd number is the
// ray as written.
void add_fan(Builder& builder, RayPath&& ray, std::vector<RayPath>& rays) {
  const unsigned count = ray.fan ? ray.fan->count : 1;
  if (rays.size() + count > builder.limits.max_entities)
    return builder.in.problem(ray.where, "more than " + counted(builder.limits.max_entities, "ray"),
                              "--max-entities raises the limit");
  ray.written_name = ray.name;
  if (count == 1) {
    ray.fan.reset();
    return rays.push_back(std::move(ray));
  }
  for (unsigned i = 0; i < count; ++i) {
    RayPath& one = rays.emplace_back(ray);
    one.fan->place = static_cast<double>(i) / (count - 1) - 0.5;
    one.name += fmt::format(" {}", i + 1);
  }
}

void read_radius(Builder& builder, const Field& field, RayPath::Ball& ball) {
  const std::optional<Moving> radius = read_moving(builder, field);
  if (!radius) return;
  if (radius->curve && !lies_between(builder.scene, *radius, 0, kFarthest))
    return builder.in.problem(field, "goes below 0 or beyond 1e300",
                              "end the curve at 0: no ball is seen then");
  if (!radius->curve && !(radius->value > 0))
    return builder.in.problem(field, "must be above 0", "write 1");
  ball.radius = *radius;
}

constexpr Key<RayPath::Ball> kBallKeys[] = {
    {{"speed", "number", "that of the ray"}, &set_number<&RayPath::Ball::speed, kSpeedRule>},
    {{"radius", "number or a curve", kRequired}, &read_radius},
    {{"colour", "\"#rrggbb\"", "the line's"}, &set<&RayPath::Ball::colour>},
};

// After the speed of the ray.
void read_ball(Builder& builder, const Field& field, RayPath& ray) {
  RayPath::Ball ball;
  ball.colour = ray.stroke.colour;
  read_keys(builder, field.value, "ray.ball", kBallKeys, ball);
  ray.ball = ball;
  const Member* speed = field.value.find("speed");
  if (speed == nullptr && !ray.speed && field.value.kind == Value::Kind::table)
    builder.in.problem(field.value.where, "ray.ball needs 'speed'",
                       "write speed = number, or a speed of the ray");
  if (speed != nullptr && ray.speed)
    builder.in.problem(speed->value.where, "the ray has a speed of its own",
                       "leave the ball's out: it goes where the ray has come to");
}

constexpr Key<RayPath> kRayKeys[] = {
    kNameKey<RayPath>,
    kGroupKey<RayPath>,
    {{"at", "[x, y] or a curve", kRequired}, &set_moving_at<RayPath>},
    {{"direction", "[dx, dy] or a curve", kRequired}, &read_direction},
    kMovingAngleKey<RayPath>,
    kVelocityKey<RayPath>,
    kAngularVelocityKey<RayPath>,
    {{"bounces", "whole number", "0"}, &set_integer<&RayPath::bounces, 0, kMaxBounces>},
    {{"speed", "number", "none"}, &set_number<&RayPath::speed, kSpeedRule>},
    {{"stroke", R"({ width = w, colour = "#rrggbb" })",
      R"({ width_px = 1.5, colour = "#d62728" })"},
     &change_stroke<RayPath>,
     true},
    {{"hit_points", "\"#rrggbb\"", "none"}, &set<&RayPath::hit_points>},
    {{"end_colour", "\"#rrggbb\"", "the stroke's"}, &set<&RayPath::end_colour>},
    {{"numbers", "\"#rrggbb\"", "none"}, &set<&RayPath::numbers>},
    {{"ball", R"({ speed = v, radius = r, colour = "#rrggbb" })", "none"}, &read_ball},
    {{"fan", "{ count = n, spread = degrees, width = w }", "none"}, &read_fan},
    kMovingOpacityKey<RayPath>,
    kLayerKey<RayPath>,
    kFollowKey<RayPath>,
    kRepeatKey<RayPath>,
};

constexpr Key<EdgeRays> kEdgeRayKeys[] = {
    {{"from", "\"ENTITY\"", kRequired}, &set_entity<&EdgeRays::from>},
    {{"against", "\"ENTITY\"", kRequired}, &set_entity<&EdgeRays::against>},
    {{"stroke", R"({ width = w, colour = "#rrggbb" })",
      R"({ width_px = 1.5, colour = "#7f7f7f" })"},
     &change_stroke<EdgeRays>},
    {{"inside", "\"#rrggbb\"", "\"#1f77b4\""}, &set<&EdgeRays::inside>},
    {{"enter", "\"#rrggbb\"", "\"#2ca02c\""}, &set<&EdgeRays::enter>},
    {{"exit", "\"#rrggbb\"", "\"#d62728\""}, &set<&EdgeRays::exit>},
    kLayerKey<EdgeRays>,
};

// What hides a ray in all frames; nothing where something of it shows.
const char* reason_unseen(const RayPath& ray) {
  if (ray.opacity.value == 0 && !ray.opacity.curve) return "its opacity is 0";
  const Paint& line = ray.stroke.colour;
  const bool clear = line.a == 0 && line.curve == kNoEntry && line.gradient == kNoEntry;
  const auto shows = [](const std::optional<Colour>& colour) { return colour && colour->a > 0; };
  const bool marked = shows(ray.hit_points) || shows(ray.end_colour) || shows(ray.numbers) ||
                      (ray.ball && ray.ball->colour.a > 0);
  return clear && !marked ? "its stroke is clear" : nullptr;
}

void read_ray(Builder& builder, const Value& table, std::uint32_t number) {
  constexpr std::uint32_t kRayTables = 7U << 29;  // apart from groups and lamps
  Scene& scene = builder.scene;
  const char* unseen = nullptr;
  const auto add = [&](RayPath&& ray, std::uint64_t copy, const std::string&) {
    if (ray.end_colour && ray.stroke.colour.curve != kNoEntry)
      builder.in.problem(table.where, "the colour of the ray is a curve, and it has an end_colour",
                         "leave one of them out");
    ray.order = draw_order(builder, table.where, copy);
    if (ray.group) ray.layer += scene.groups[*ray.group].layer;
    if (const char* reason = reason_unseen(ray)) unseen = reason;
    add_fan(builder, std::move(ray), scene.rays);
  };
  make_copies<RayPath>(builder, table, {"ray", kRayTables + number, scene.rays.size()}, kRayKeys,
                       add);
  if (unseen != nullptr)
    builder.in.warning(table.where, fmt::format("the ray draws nothing: {}", unseen),
                       "leave the ray out, or let it be seen");
}

}  // namespace

void read_rays(Builder& builder, const Field& field, Scene& scene) {
  std::uint32_t tables = 0;
  each_table(builder, field, [&](const Value& table) { read_ray(builder, table, tables++); });
  if (std::ranges::any_of(scene.rays, [](const RayPath& ray) { return ray.speed.has_value(); }))
    builder.in.add(refused_mirrors(scene));
}

// Only straight edges are cast as rays.
bool has_straight_lines(const Shape& shape) {
  return !shape.vertices.empty() || !shape.segments.empty() ||
         std::ranges::any_of(shape.arc_paths, [](const ArcPath& path) {
           return std::ranges::any_of(walls_of(path),
                                      [](const PathWall& wall) { return !wall.arc; });
         });
}

void read_edge_rays(Builder& builder, const Field& field, Scene& scene) {
  each_table(builder, field, [&](const Value& table) {
    EdgeRays rays{0,     0,           {1.5, true, kGrey},
                  kBlue, kGreen,      kRed,
                  0,     table.where, draw_order(builder, table.where)};
    read_keys(builder, table, "edge_rays", kEdgeRayKeys, rays);
    scene.edge_rays.push_back(rays);
    if (!builder.in.problems.empty()) return;
    const Entity& from = scene.entities[rays.from];
    if (!from.markov && !has_straight_lines(scene.shapes[from.shape]))
      builder.in.warning(
          table.find("from")->where, "has no straight edges: these rays draw nothing",
          "name an entity that has, as lines, or a polygon whose edges do not cross");
  });
}

std::vector<TableInfo> ray_tables() {
  return {{"ray", key_infos<RayPath>(kRayKeys), true},
          {"ray.fan", key_infos<RayPath::Fan>(kFanKeys), true},
          {"ray.ball", key_infos<RayPath::Ball>(kBallKeys), true},
          {"edge_rays", key_infos<EdgeRays>(kEdgeRayKeys)}};
}

}  // namespace flatray
