#include "transport/light/lit_walls.h"

#include <algorithm>

#include "base/check.h"
#include "transport/light/order.h"

namespace flatray {

LitWalls::LitWalls(const World& world, std::span<const Scatterer* const> scatterers,
                   const Tracer* tracer)
    : walls_(world.surfaces),
      materials_(world.materials()),
      scatterers_(scatterers),
      bodies_(world, scatterers),
      lander_(walls_),
      tracer_(choose_tracer(walls_, tracer).tracer->build(walls_)) {}

bool LitWalls::sets_off(LightRay& ray) const {
  const std::vector<std::uint32_t> stood_on = lander_.walls_at(ray.ray.origin);
  if (bodies_.any()) ray.media = bodies_.around(ray.ray.origin);
  if (stood_on.empty()) return true;
  if (stood_on.size() > 1 || is_end(walls_, stood_on.front(), ray.ray.origin)) return false;
  ray.left = {stood_on.front(), root_stood_on(walls_, stood_on.front(), ray.ray)};
  if (runs_along(walls_, ray.left, ray.ray.direction)) return false;
  const std::uint32_t body = bodies_.of(ray.left.surface);
  if (body != Media::kNone && goes_inside(walls_, ray.left, ray.ray.direction))
    ray.media.enter(body);
  return true;
}

void LitWalls::fly(std::span<const LightRay> rays, std::span<LightLanding> landings) const {
  RayBatch batch;
  batch.tangents = false;
  for (const LightRay& ray : rays) batch.add(ray.ray, ray.left);
  std::vector<NearestHit> hits(rays.size());
  tracer_->nearest(batch, hits);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    landings[i].hit = hits[i];
    if (hits[i]) landings[i].landing = lander_.land(rays[i].ray, hits[i]);
  }
}

Arrival LitWalls::arrival(const LightRay& ray, const LightLanding& landed) const {
  const Sign side = inner_side(walls_, ray.ray, landed.hit);
  const Vec2 normal = static_cast<double>(side) * unit(landed.landing.normal);
  const auto nm = static_cast<double>(ray.nm);
  const std::uint32_t surface = landed.hit.surface;
  const bool placed = scatterers_[surface] != nullptr && scatterers_[surface]->depends_on_place() &&
                      walls_.is_straight(surface);
  return {ray.ray.direction,
          normal,
          from_inside(walls_, ray.ray, landed.hit),
          bodies_.index_around(ray.media, bodies_.of(surface), nm),
          nm,
          placed ? share_along(walls_, surface, landed.landing.point) : 0.0};
}

Departure LitWalls::depart(const LightLanding& landed, const Arrival& arrival, double u) const {
  const std::uint32_t surface = landed.hit.surface;
  if (scatterers_[surface] != nullptr) return scatterers_[surface]->scatter(arrival, u);
  return {materials_[surface] == Material::mirror ? Departure::Way::mirrored
                                                  : Departure::Way::absorbed};
}

bool LitWalls::all_absorb(std::span<const std::uint32_t> surfaces) const {
  return std::all_of(surfaces.begin(), surfaces.end(), [&](std::uint32_t i) {
    return scatterers_[i] == nullptr && materials_[i] == Material::absorb;
  });
}

bool LitWalls::sets_off_from(LightRay& ray, const Ray& came, const LightLanding& landed,
                             bool stays) const {
  const std::uint32_t surface = landed.hit.surface;
  ray.ray.origin = landed.landing.point;
  ray.left = {surface, root_stood_on(walls_, surface, ray.ray)};
  return !runs_along(walls_, ray.left, ray.ray.direction) &&
         (!stays || leads_away(walls_, surface, inner_side(walls_, came, landed.hit),
                               ray.ray.origin, ray.ray.direction));
}

bool LitWalls::leaves(LightRay& ray, const LightLanding& landed, const Departure& departure) const {
  const Ray came = ray.ray;
  const std::uint32_t surface = landed.hit.surface;
  ray.ray.origin = landed.landing.point;
  switch (departure.way) {
    case Departure::Way::absorbed:
      return false;
    case Departure::Way::through:
      ray.left = {surface, landed.hit.root};
      return true;
    case Departure::Way::mirrored: {
      const auto reflection = reflect_off(walls_, came, landed.hit, landed.landing, speed_);
      if (!reflection) return false;
      ray.ray.direction = reflection->direction;
      ray.left = {surface, root_left_by(landed.hit.root)};
      return true;
    }
    case Departure::Way::scattered:
      ray.ray.direction = departure.direction;
      if (!sets_off_from(ray, came, landed, departure.stays)) return false;
      change_media(ray, surface, from_inside(walls_, came, landed.hit));
      return true;
  }
  unreachable();
}

void LitWalls::change_media(LightRay& ray, std::uint32_t surface, bool was_inside) const {
  const std::uint32_t body = bodies_.of(surface);
  if (body == Media::kNone) return;
  const bool is_inside = goes_inside(walls_, ray.left, ray.ray.direction);
  if (was_inside && !is_inside) ray.media.leave(body);
  if (!was_inside && is_inside) ray.media.enter(body);
}

}  // namespace flatray
