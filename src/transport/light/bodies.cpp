#include "transport/light/bodies.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/portable_math.h"

namespace flatray {
namespace {

// Points as seen from the middle of a body, in a unit that is a power of two of its size.
struct BodyFrame {
  Vec2 middle;
  int power;
  Vec2 vector(const Vec2& v) const {
    return {std::ldexp(v.x(), -power), std::ldexp(v.y(), -power)};
  }
  Vec2 operator()(const Vec2& point) const { return vector(point - middle); }
};

// Twice the area that the line from the middle to a wall passes over, as one goes along the wall with
// its body to the left; positive to the left of that line.
double twice_swept(const Segment& wall, const BodyFrame& frame) {
  return cross(frame(wall.a), frame(wall.b));
}
double twice_swept(const Arc& wall, const BodyFrame& frame) {
  constexpr auto kNumber = [](double x) { return x; };
  const Ellipse curve(frame(wall.curve.centre), frame.vector(wall.curve.u),
                      frame.vector(wall.curve.v));
  const auto form = [&](const Vec2& vector) {
    const auto [x, y] = curve_form(kNumber, curve, pair_of(kNumber, vector));
    return Vec2(x, y);
  };
  double sweep = 2 * std::numbers::pi;
  Vec2 way(0, 0);
  if (wall.extent == Arc::Extent::half) {
    sweep = std::numbers::pi;
    const Vec2 across = unit(Vec2(-wall.from.y(), wall.from.x()));
    way = 2 * form_size(kNumber, curve) / form(across).norm() * across;
  } else if (wall.extent == Arc::Extent::between) {
    const Vec2 from = form(frame(wall.from) - curve.centre),
               to = form(frame(wall.to) - curve.centre);
    sweep = portable::atan2(cross(from, to), from.dot(to));
    if (sweep < 0) sweep += 2 * std::numbers::pi;
    way = frame.vector(wall.to - wall.from);
  }
  const double twice = sweep * cross(curve.u, curve.v) + cross(curve.centre, way);
  return wall.is_hollow ? -twice : twice;
}
double twice_swept(const Bezier&, const BodyFrame&) { return 0; }  // no body has one

}  // namespace

Bodies::Bodies(const World& world, std::span<const Scatterer* const> scatterers)
    : walls_(world.surfaces), bodies_(scatterers.size(), Media::kNone) {
  const SurfaceOwner* last = nullptr;  // surfaces of one owner follow one another
  for (std::uint32_t i = 0; i < scatterers.size(); ++i) {
    if (scatterers[i] == nullptr || scatterers[i]->index(0) == 0) continue;
    const SurfaceOwner& owner = world.owners[i];
    if (last == nullptr || owner.kind != last->kind || owner.index != last->index ||
        owner.pillar != last->pillar)
      all_.push_back({scatterers[i], scatterers[i]->absorption()});
    last = &owner;
    all_.back().surfaces.push_back(i);
  }
  for (Body& body : all_) {
    disperse_ |= body.scatterer->disperses();
    absorb_ |= body.absorption != std::array<double, 3>{0, 0, 0};
    for (const std::uint32_t surface : body.surfaces)
      body.bounds.add(walls_.visit(surface, [](const auto& wall) { return bounds_of(wall); }));
    BodyFrame frame{body.bounds.centre(), 0};
    std::frexp(body.bounds.size().maxCoeff(), &frame.power);
    double twice = 0;
    for (const std::uint32_t surface : body.surfaces)
      twice += walls_.visit(surface, [&](const auto& wall) { return twice_swept(wall, frame); });
    const double part = std::frexp(std::fabs(twice), &body.area.first);
    body.area = {body.area.first + 2 * frame.power, std::nearbyint(0x1p26 * part)};
  }
  std::ranges::stable_sort(all_, std::ranges::greater(), &Body::area);
  std::vector<Bounds> boxes;
  for (std::uint32_t i = 0; i < all_.size(); ++i) {
    for (const std::uint32_t surface : all_[i].surfaces) bodies_[surface] = i;
    boxes.push_back(all_[i].bounds);
  }
  boxes_ = BoxTree(std::move(boxes));
}

// By the crossings of the half line to the right.
bool Bodies::holds(const Body& body, const Vec2& point) const {
  bool inside = false;
  for (const std::uint32_t surface : body.surfaces) {
    const bool on_it = walls_.visit(surface, [&](const auto& wall) {
      inside ^= crosses_to_right(wall, point);
      return place_on(wall, point) != PlaceOn::outside;
    });
    if (on_it) return false;
  }
  return inside;
}

std::array<double, 3> Bodies::left_after(double length, const Media& media) const {
  if (!absorb_) return {1, 1, 1};
  const std::array<double, 3>& absorption = absorption_in(media);
  return {fading(absorption[0], length).left, fading(absorption[1], length).left,
          fading(absorption[2], length).left};
}

Media Bodies::around(const Vec2& point) const {
  Media media;
  for (const std::size_t body : boxes_.near({point, point}))
    if (holds(all_[body], point)) media.enter(static_cast<std::uint32_t>(body));
  return media;
}

Media Bodies::at(const Ray& ray, const DepartedSurface& departed) const {
  Media media = around(ray.origin);
  const std::uint32_t body = departed.surface == kNoSurface ? Media::kNone : of(departed.surface);
  if (body == Media::kNone) return media;
  media.leave(body);  // it stands on its wall, but for rounding
  if (goes_inside(walls_, departed, ray.direction)) media.enter(body);
  return media;
}

Fading fading(double absorption, double length) {
  const double depth = absorption * length;
  if (!(depth > 0)) return {1, 1};
  const double left = portable::exp(-depth);
  // Of little the difference from 1 is: (1 - exp(-x)) / x by its series, whose next term is x^4 / 120.
  const double series = 1 - depth / 2 * (1 - depth / 3 * (1 - depth / 4));
  return {left, depth < 0x1p-10 ? series : (1 - left) / depth};
}

bool goes_inside(const Surfaces& walls, const DepartedSurface& departed, const Vec2& direction) {
  return walls.visit(departed.surface, [&](const auto& wall) {
    return -side_met(wall, {{0, 0}, direction}, departed.root) == inside_of(wall);
  });
}

}  // namespace flatray
