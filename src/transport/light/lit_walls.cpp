#include "transport/light/lit_walls.h"

#include <algorithm>

#include "base/check.h"
#include "transport/light/order.h"
#include "transport/orbit.h"

namespace flatray {

LitWalls::LitWalls(const World& world, std::span<const Scatterer* const> scatterers,
                   const Tracer* tracer)
    : walls_(world.surfaces),
      owners_(world.owners),
      materials_(world.materials()),
      scatterers_(scatterers),
      bodies_(world, scatterers),
      exact_origins_(walls_),
      offset_origins_(walls_),
      kind_(*choose_tracer(walls_, tracer).tracer),
      tracer_(kind_.build(walls_)) {}

// Where no double is found on that side, leaving the wall is enough: it is not met again.
bool LitWalls::sets_off_beside(LightRay& ray, std::uint32_t surface) const {
  Ray& from = ray.ray;
  const bool left = leads_away(walls_, surface, Sign::positive, from.origin, from.direction);
  const Sign to = left ? Sign::positive : Sign::negative;
  if (walls_.visit(surface, [&](const auto& wall) { return side_of(wall, from.origin); }) != to)
    if (const auto there = exact_origins_.across(from.origin, surface, -to)) from.origin = *there;
  ray.departed = {surface,
                  walls_.visit(surface, [&](const auto& wall) { return root_departed(wall, to); })};
  return !runs_along(walls_, ray.departed, from.direction);
}

bool LitWalls::sets_off(LightRay& ray, const WallsBeside& beside) const {
  const std::vector<std::uint32_t> stood_on = exact_origins_.walls_at(ray.ray.origin);
  if (!stood_on.empty()) {
    if (stood_on.size() > 1 || is_end(walls_, stood_on.front(), ray.ray.origin)) return false;
    ray.departed = {stood_on.front(), root_stood_on(walls_, stood_on.front(), ray.ray)};
    if (runs_along(walls_, ray.departed, ray.ray.direction)) return false;
  } else if (!beside.walls.empty()) {
    const Vec2 reach(beside.reach, beside.reach);
    const auto wall = std::ranges::find_if(beside.walls, [&](std::uint32_t i) {
      return walls_.visit(i,
                          [&](const auto& one) { return passes_near(one, ray.ray.origin, reach); });
    });
    if (wall != beside.walls.end() && !sets_off_beside(ray, *wall)) return false;
  }
  if (bodies_.any()) ray.media = bodies_.at(ray.ray, ray.departed);
  return true;
}

void LitWalls::fly(std::span<const LightRay> rays, std::span<LightHit> met) const {
  RayBatch batch;
  batch.tangents = false;
  batch.resize(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) batch.set(i, rays[i].ray, rays[i].departed);
  std::vector<NearestHit> hits(rays.size());
  tracer_->nearest(batch, hits);
  for (std::size_t i = 0; i < rays.size(); ++i)
    met[i] = hits[i] ? light_hit(rays[i].ray, hits[i]) : LightHit{};
}

LightHit LitWalls::light_hit(const Ray& ray, const NearestHit& hit) const {
  const Sign inside = inside_at(hit.surface);
  if (const auto met = kind_.exact ? offset_origins_.meet(ray, hit) : std::nullopt) {
    const bool back = met->normal.dot(ray.direction) < 0;  // to the side of the normal
    return {hit,
            false,
            back == (inside == Sign::positive),
            met->point,
            back ? met->normal : Vec2(-met->normal),
            offset_origins_.distance()};
  }
  const ExactOrigin origin = exact_origins_.after(ray, hit);
  if (!origin.corner.empty()) return {hit, true, false, origin.point};
  const Sign side = inner_side(walls_, ray, hit);
  return {hit, false, side == inside, origin.point,
          static_cast<double>(side) * unit(origin.normal)};
}

Sign LitWalls::inside_at(std::uint32_t surface) const {
  return walls_.visit(surface, [](const auto& wall) { return inside_of(wall); });
}

Sign LitWalls::side(const LightHit& met) const {
  const Sign inside = inside_at(met.hit.surface);
  return met.from_inside ? inside : -inside;
}

Arrival LitWalls::arrival(const LightRay& ray, const LightHit& met) const {
  const auto nm = static_cast<double>(ray.nm);
  const std::uint32_t surface = met.hit.surface;
  double along = 0;
  if (scatterers_[surface] != nullptr && scatterers_[surface]->depends_on_place() &&
      walls_.segment_slot(surface) != kNoSurface) {
    along = share_along(walls_.segment(surface), met.point);
    if (owners_[surface].turned) along = 1 - along;
  }
  return {ray.ray.direction,
          met.normal,
          met.from_inside,
          bodies_.index_around(ray.media, bodies_.of(surface), nm),
          nm,
          along};
}

Departure LitWalls::depart(const LightHit& met, const Arrival& arrival, double u) const {
  const std::uint32_t surface = met.hit.surface;
  if (scatterers_[surface] != nullptr) return scatterers_[surface]->scatter(arrival, u);
  return {materials_[surface] == Material::mirror ? Departure::Way::mirrored
                                                  : Departure::Way::absorbed};
}

bool LitWalls::all_absorb(const LightRay& ray, const LightHit& met) const {
  const std::vector<std::uint32_t> corner = exact_origins_.after(ray.ray, met.hit).corner;
  const bool scatter =
      std::ranges::any_of(corner, [&](std::uint32_t i) { return scatterers_[i] != nullptr; });
  return !scatter && !taken_by(materials_, corner).empty();
}

bool LitWalls::goes_beyond(Ray& ray, const LightHit& met) const {
  if (met.offset != 0) {
    ray.origin = met.point - met.offset * met.normal;
    return true;
  }
  const auto there = exact_origins_.across(met.point, met.hit.surface, side(met));
  if (there) ray.origin = *there;
  return there.has_value();
}

bool LitWalls::sets_off_from(LightRay& ray, const LightHit& met, bool stays) const {
  const std::uint32_t surface = met.hit.surface;
  const Vec2& direction = ray.ray.direction;
  ray.ray.origin = met.point;
  if (met.offset == 0) {
    const bool back = leads_away(walls_, surface, side(met), met.point, direction);
    if (stays && !back) return false;
    if (!back && !goes_beyond(ray.ray, met)) return false;
    ray.departed = {surface, root_stood_on(walls_, surface, ray.ray)};
    return !runs_along(walls_, ray.departed, direction);
  }
  const double cosine = met.normal.dot(direction);
  constexpr double kLeast = OffsetOrigins::kLeastCosine * OffsetOrigins::kLeastCosine;
  const bool straight = walls_.segment_slot(surface) != kNoSurface;
  const bool grazes = !(cosine * cosine > kLeast * direction.squaredNorm());
  if (grazes && runs_along(walls_, {surface, Root::none}, direction)) return false;
  const bool back = grazes && straight
                        ? leads_away(walls_, surface, side(met), met.point, direction)
                        : cosine > 0;
  ray.ray.origin += (back ? met.offset : -met.offset) * met.normal;
  const Sign to = back ? side(met) : -side(met);
  ray.departed = {surface,
                  walls_.visit(surface, [&](const auto& wall) { return root_departed(wall, to); })};
  if (stays && !back) return false;
  // A ray beside a curve that it only seems to leave would meet it again.
  return !grazes || ray.departed.root != Root::second ||
         leads_away(walls_, surface, Sign::positive, ray.ray.origin, direction);
}

bool LitWalls::leaves(LightRay& ray, const LightHit& met, const Departure& departure) const {
  const std::uint32_t surface = met.hit.surface;
  switch (departure.way) {
    case Departure::Way::absorbed:
      return false;
    case Departure::Way::through:
      ray.departed = {surface, met.hit.root};
      return goes_beyond(ray.ray, met);
    case Departure::Way::mirrored:
      ray.departed = {surface, root_departed_by(met.hit.root)};
      return mirrors(ray.ray, met);
    case Departure::Way::scattered:
      ray.ray.direction = departure.direction;
      if (!sets_off_from(ray, met, departure.stays)) return false;
      change_media(ray, met);
      return true;
  }
  unreachable();
}

bool LitWalls::mirrors(Ray& ray, const LightHit& met) const {
  const Vec2& normal = met.normal;
  const Ray came = ray;
  ray.origin = met.point + met.offset * normal;
  if (met.offset > 0) {
    ray.direction -= 2 * normal.dot(came.direction) * normal;
    return true;
  }
  const ExactOrigin origin{met.point, {}, static_cast<double>(side(met)) * normal};
  const auto reflection = reflect_off(walls_, came, met.hit, origin, speed_);
  if (reflection) ray.direction = reflection->direction;
  return reflection.has_value();
}

void LitWalls::change_media(LightRay& ray, const LightHit& met) const {
  const std::uint32_t body = bodies_.of(met.hit.surface);
  if (body == Media::kNone) return;
  const bool is_inside = goes_inside(walls_, ray.departed, ray.ray.direction);
  if (met.from_inside && !is_inside) ray.media.leave(body);
  if (!met.from_inside && is_inside) ray.media.enter(body);
  if (ray.media.forgets()) ray.media = bodies_.at(ray.ray, ray.departed);
}

}  // namespace flatray
