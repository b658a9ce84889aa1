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
      origins_(walls_),
      kind_(*choose_tracer(walls_, tracer).tracer),
      tracer_(kind_.build(walls_)) {}

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
  batch.resize(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) batch.set(i, rays[i].ray, rays[i].left);
  std::vector<NearestHit> hits(rays.size());
  tracer_->nearest(batch, hits);
  for (std::size_t i = 0; i < rays.size(); ++i)
    landings[i] = hits[i] ? land(rays[i].ray, hits[i]) : LightLanding{};
}

LightLanding LitWalls::land(const Ray& ray, const NearestHit& hit) const {
  const Sign inside = inside_at(hit.surface);
  if (const auto met = kind_.exact ? origins_.meet(ray, hit) : std::nullopt) {
    const bool back = met->normal.dot(ray.direction) < 0;  // to the side of the normal
    return {hit,
            false,
            back == (inside == Sign::positive),
            met->point,
            back ? met->normal : Vec2(-met->normal),
            origins_.distance()};
  }
  const Landing landing = lander_.land(ray, hit);
  if (!landing.corner.empty()) return {hit, true, false, landing.point};
  const Sign side = inner_side(walls_, ray, hit);
  return {hit, false, side == inside, landing.point,
          static_cast<double>(side) * unit(landing.normal)};
}

Sign LitWalls::inside_at(std::uint32_t surface) const {
  return walls_.visit(surface, [](const auto& wall) { return inside_of(wall); });
}

Sign LitWalls::side(const LightLanding& landed) const {
  const Sign inside = inside_at(landed.hit.surface);
  return landed.from_inside ? inside : -inside;
}

Arrival LitWalls::arrival(const LightRay& ray, const LightLanding& landed) const {
  const auto nm = static_cast<double>(ray.nm);
  const std::uint32_t surface = landed.hit.surface;
  const bool placed = scatterers_[surface] != nullptr && scatterers_[surface]->depends_on_place() &&
                      walls_.segment_slot(surface) != kNoSurface;
  return {ray.ray.direction,
          landed.normal,
          landed.from_inside,
          bodies_.index_around(ray.media, bodies_.of(surface), nm),
          nm,
          placed ? share_along(walls_.segment(surface), landed.point) : 0.0};
}

Departure LitWalls::depart(const LightLanding& landed, const Arrival& arrival, double u) const {
  const std::uint32_t surface = landed.hit.surface;
  if (scatterers_[surface] != nullptr) return scatterers_[surface]->scatter(arrival, u);
  return {materials_[surface] == Material::mirror ? Departure::Way::mirrored
                                                  : Departure::Way::absorbed};
}

bool LitWalls::all_absorb(const LightRay& ray, const LightLanding& landed) const {
  const std::vector<std::uint32_t> corner = lander_.land(ray.ray, landed.hit).corner;
  return std::all_of(corner.begin(), corner.end(), [&](std::uint32_t i) {
    return scatterers_[i] == nullptr && materials_[i] == Material::absorb;
  });
}

bool LitWalls::sets_off_from(LightRay& ray, const LightLanding& landed, bool stays) const {
  const std::uint32_t surface = landed.hit.surface;
  const Vec2& direction = ray.ray.direction;
  ray.ray.origin = landed.point;
  if (landed.offset == 0) {
    ray.left = {surface, root_stood_on(walls_, surface, ray.ray)};
    return !runs_along(walls_, ray.left, direction) &&
           (!stays || leads_away(walls_, surface, side(landed), ray.ray.origin, direction));
  }
  const double cosine = landed.normal.dot(direction);
  constexpr double kLeast = OffsetOrigins::kLeastCosine * OffsetOrigins::kLeastCosine;
  const bool straight = walls_.segment_slot(surface) != kNoSurface;
  const bool grazes = !(cosine * cosine > kLeast * direction.squaredNorm());
  if (grazes && runs_along(walls_, {surface, Root::none}, direction)) return false;
  const bool back = grazes && straight
                        ? leads_away(walls_, surface, side(landed), landed.point, direction)
                        : cosine > 0;
  ray.ray.origin += (back ? landed.offset : -landed.offset) * landed.normal;
  const Sign to = back ? side(landed) : -side(landed);
  ray.left = {surface,
              walls_.visit(surface, [&](const auto& wall) { return root_left(wall, to); })};
  if (stays && !back) return false;
  // A ray beside a curve that it only seems to leave would meet it again.
  return !grazes || ray.left.root != Root::second ||
         leads_away(walls_, surface, Sign::positive, ray.ray.origin, direction);
}

bool LitWalls::leaves(LightRay& ray, const LightLanding& landed, const Departure& departure) const {
  const std::uint32_t surface = landed.hit.surface;
  switch (departure.way) {
    case Departure::Way::absorbed:
      return false;
    case Departure::Way::through:
      ray.ray.origin = landed.point - landed.offset * landed.normal;
      ray.left = {surface, landed.hit.root};
      return true;
    case Departure::Way::mirrored:
      ray.left = {surface, root_left_by(landed.hit.root)};
      return mirrors(ray.ray, landed);
    case Departure::Way::scattered:
      ray.ray.direction = departure.direction;
      if (!sets_off_from(ray, landed, departure.stays)) return false;
      change_media(ray, landed);
      return true;
  }
  unreachable();
}

bool LitWalls::mirrors(Ray& ray, const LightLanding& landed) const {
  const Vec2& normal = landed.normal;
  const Ray came = ray;
  ray.origin = landed.point + landed.offset * normal;
  if (landed.offset > 0) {
    ray.direction -= 2 * normal.dot(came.direction) * normal;
    return true;
  }
  const Landing landing{landed.point, {}, static_cast<double>(side(landed)) * normal};
  const auto reflection = reflect_off(walls_, came, landed.hit, landing, speed_);
  if (reflection) ray.direction = reflection->direction;
  return reflection.has_value();
}

void LitWalls::change_media(LightRay& ray, const LightLanding& landed) const {
  const std::uint32_t body = bodies_.of(landed.hit.surface);
  if (body == Media::kNone) return;
  const bool is_inside = goes_inside(walls_, ray.left, ray.ray.direction);
  if (landed.from_inside && !is_inside) ray.media.leave(body);
  if (!landed.from_inside && is_inside) ray.media.enter(body);
}

}  // namespace flatray
