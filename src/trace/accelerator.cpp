// Answers that every tracer gives by its nearest hits or by exact ones.
#include "trace/exact_nearest.h"
#include "trace/tracer.h"

namespace flatray {
namespace {

// Of a hit whose t, rounded to the nearest, may stand for one that is later: rounding keeps order,
// so only where both are the same the exact t has to be asked.
bool is_met_by(const Surfaces& walls, const Ray& ray, const NearestHit& hit,
               const DepartedSurface& departed, bool tangents, double up_to) {
  if (!hit || hit.t != up_to) return hit && hit.t < up_to;
  ExactNearest alone(walls, ray, departed, tangents);
  alone.offer(hit.surface);
  return !alone.time() || alone.time()->compare(up_to) <= 0;
}

}  // namespace

void Accelerator::nearest(const RayBatch& rays, std::span<NearestHit> hits) const {
  for (std::size_t i = 0; i < rays.size(); ++i)
    hits[i] = nearest_of_one(rays.ray(i), rays.departed[i], rays.tangents);
}

NearestHit Accelerator::nearest_of_one(const Ray& ray, const DepartedSurface& departed,
                                       bool tangents) const {
  RayBatch rays;
  rays.tangents = tangents;
  rays.add(ray, departed);
  NearestHit hit;
  nearest(rays, {&hit, 1});
  return hit;
}

std::size_t Accelerator::tested_of_one(const Ray&, const DepartedSurface&) const {
  return walls_.size();
}

void Accelerator::any(const RayBatch& rays, std::span<const double> up_to,
                      std::span<std::uint8_t> met) const {
  std::vector<NearestHit> hits(rays.size());
  nearest(rays, hits);
  for (std::size_t i = 0; i < hits.size(); ++i)
    met[i] =
        is_met_by(walls_, rays.ray(i), hits[i], rays.departed[i], rays.tangents, up_to[i]) ? 1 : 0;
}

bool Accelerator::any_of_one(const Ray& ray, double up_to, const DepartedSurface& departed,
                             bool tangents) const {
  return is_met_by(walls_, ray, nearest_of_one(ray, departed, tangents), departed, tangents, up_to);
}

std::vector<NearestHit> Accelerator::all_of_one(const Ray& ray, const DepartedSurface& departed,
                                                bool tangents) const {
  ExactNearest every(walls_, ray, departed, tangents, true);
  every.offer_all();
  return every.hits();
}

}  // namespace flatray
