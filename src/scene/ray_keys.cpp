#include <algorithm>
#include <cmath>

#include "base/counted.h"
#include "geom/turn.h"
#include "scene/look_keys.h"
#include "scene/moving_mirrors.h"
#include "scene/scene_keys.h"

namespace flatray {
namespace {

constexpr Colour kRed{0xd6, 0x27, 0x28, 255}, kGreen{0x2c, 0xa0, 0x2c, 255},
    kBlue{0x1f, 0x77, 0xb4, 255}, kGrey{0x7f, 0x7f, 0x7f, 255};
constexpr std::int64_t kMaxBounces = 100'000;
constexpr std::int64_t kMaxFan = 10'000;

template <auto Pointer>
void change_stroke(Builder& builder, const Field& field,
                   typename MemberOf<decltype(Pointer)>::Owner& target) {
  read_stroke(builder, field, target.*Pointer);
}

void read_direction(Builder& builder, const Field& field, RayPath& ray) {
  const auto direction = builder.in.point(field);
  if (!direction) return;
  if (*direction == Vec2(0, 0))
    return builder.in.problem(field.value.where, field.name + " has no length",
                              "write where the ray goes, at any length");
  ray.direction = *direction;
}

template <auto Pointer>
void set_entity(Builder& builder, const Field& field, EdgeRays& rays) {
  const auto entity = find_entity(builder, field);
  if (!entity) return;
  rays.*Pointer = *entity;
}

template <auto Pointer>
void set_positive(Builder& builder, const Field& field,
                  typename MemberOf<decltype(Pointer)>::Owner& target) {
  const auto value = builder.in.number(field);
  if (!value) return;
  if (!(*value > 0))
    return builder.in.problem(field.value.where, field.name + " must be above 0", "write 1");
  target.*Pointer = *value;
}

constexpr Key<RayPath::Fan> kFanKeys[] = {
    {{"count", "whole number", kRequired}, &set_integer<&RayPath::Fan::count, 1, kMaxFan>},
    {{"spread", "degrees", "0"}, &set_angle<&RayPath::Fan::spread>},
    {{"width", "number", "0"}, &set<&RayPath::Fan::width>},
};

void read_fan(Builder& builder, const Field& field, RayPath& ray) {
  RayPath::Fan fan;
  read_keys<RayPath::Fan>(builder, field.value, "ray.fan", kFanKeys, fan);
  ray.fan = fan;
}

// The rays of a fan from the first to the last, to the left; the middle one of an odd number is the
// ray as written.
void add_fan(Builder& builder, const RayPath& ray, std::vector<RayPath>& rays) {
  const RayPath::Fan fan = ray.fan.value_or(RayPath::Fan{});
  if (rays.size() + fan.count > builder.limits.max_entities)
    return builder.in.problem(ray.where, "more than " + counted(builder.limits.max_entities, "ray"),
                              "--max-entities raises the limit");
  const Vec2& d = ray.direction;
  const double size = std::max(std::fabs(d.x()), std::fabs(d.y()));
  const Vec2 along = d / size, left = Vec2(-along.y(), along.x()) / std::sqrt(along.dot(along));
  for (unsigned i = 0; i < fan.count; ++i) {
    RayPath one = ray;
    one.fan.reset();
    one.written_name = ray.name;
    const double place = fan.count == 1 ? 0 : static_cast<double>(i) / (fan.count - 1) - 0.5;
    const Turn by = turn(place * fan.spread);
    one.direction = {by.cos * d.x() - by.sin * d.y(), by.sin * d.x() + by.cos * d.y()};
    one.at += place * fan.width * left;
    if (fan.count > 1) one.name += fmt::format(" {}", i + 1);
    rays.push_back(std::move(one));
  }
}

constexpr Key<RayPath::Ball> kBallKeys[] = {
    {{"speed", "number", "that of the ray"}, &set_positive<&RayPath::Ball::speed>},
    {{"radius", "number", kRequired}, &set_positive<&RayPath::Ball::radius>},
    {{"colour", "\"#rrggbb\"", "the line's"}, &set<&RayPath::Ball::colour>},
};

// After the speed of the ray.
void read_ball(Builder& builder, const Field& field, RayPath& ray) {
  RayPath::Ball ball;
  ball.colour = ray.stroke.colour;
  read_keys<RayPath::Ball>(builder, field.value, "ray.ball", kBallKeys, ball);
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
    {{"at", "[x, y]", kRequired}, &set<&RayPath::at>},
    {{"direction", "[dx, dy]", kRequired}, &read_direction},
    {{"bounces", "whole number", "0"}, &set_integer<&RayPath::bounces, 0, kMaxBounces>},
    {{"speed", "number", "none"}, &set_positive<&RayPath::speed>},
    {{"stroke", R"({ width = w, colour = "#rrggbb" })",
      R"({ width_px = 1.5, colour = "#d62728" })"},
     &change_stroke<&RayPath::stroke>},
    {{"hit_points", "\"#rrggbb\"", "none"}, &set<&RayPath::hit_points>},
    {{"end_colour", "\"#rrggbb\"", "the stroke's"}, &set<&RayPath::end_colour>},
    {{"numbers", "\"#rrggbb\"", "none"}, &set<&RayPath::numbers>},
    {{"ball", R"({ speed = v, radius = r, colour = "#rrggbb" })", "none"}, &read_ball},
    {{"fan", "{ count = n, spread = degrees, width = w }", "none"}, &read_fan},
    kOpacityKey<RayPath>,
    kLayerKey<RayPath>,
};

constexpr Key<EdgeRays> kEdgeRayKeys[] = {
    {{"from", "\"ENTITY\"", kRequired}, &set_entity<&EdgeRays::from>},
    {{"against", "\"ENTITY\"", kRequired}, &set_entity<&EdgeRays::against>},
    {{"stroke", R"({ width = w, colour = "#rrggbb" })",
      R"({ width_px = 1.5, colour = "#7f7f7f" })"},
     &change_stroke<&EdgeRays::stroke>},
    {{"inside", "\"#rrggbb\"", "\"#1f77b4\""}, &set<&EdgeRays::inside>},
    {{"enter", "\"#rrggbb\"", "\"#2ca02c\""}, &set<&EdgeRays::enter>},
    {{"exit", "\"#rrggbb\"", "\"#d62728\""}, &set<&EdgeRays::exit>},
    kLayerKey<EdgeRays>,
};

}  // namespace

void read_rays(Builder& builder, const Field& field, Scene& scene) {
  each_table(builder, field, [&](const Value& table) {
    RayPath ray;
    ray.stroke = {1.5, true, kRed};
    ray.where = table.where;
    ray.order = draw_order(builder, table.where);
    read_keys<RayPath>(builder, table, "ray", kRayKeys, ray);
    add_fan(builder, ray, scene.rays);
  });
  if (!std::any_of(scene.rays.begin(), scene.rays.end(),
                   [](const RayPath& ray) { return ray.speed.has_value(); }))
    return;
  for (Diagnostic& problem : refused_mirrors(scene))
    builder.in.problems.push_back(std::move(problem));
}

void read_edge_rays(Builder& builder, const Field& field, Scene& scene) {
  each_table(builder, field, [&](const Value& table) {
    EdgeRays rays{0,     0,           {1.5, true, kGrey},
                  kBlue, kGreen,      kRed,
                  0,     table.where, draw_order(builder, table.where)};
    read_keys<EdgeRays>(builder, table, "edge_rays", kEdgeRayKeys, rays);
    scene.edge_rays.push_back(rays);
  });
}

std::vector<TableInfo> ray_tables() {
  return {{"ray", key_infos<RayPath>(kRayKeys)},
          {"ray.fan", key_infos<RayPath::Fan>(kFanKeys)},
          {"ray.ball", key_infos<RayPath::Ball>(kBallKeys)},
          {"edge_rays", key_infos<EdgeRays>(kEdgeRayKeys)}};
}

}  // namespace flatray
