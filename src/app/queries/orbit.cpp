#include "transport/orbit.h"

#include "app/query/query.h"
#include "precise/proven_bounces.h"

namespace flatray::queries {
namespace {

constexpr std::uint64_t kMostBounces = 1'000'000;  // an answer is one line in memory

JsonValue as_json(const Vec2& point) { return Values{point.x(), point.y()}; }

Fields answer(Question& question) {
  const Ray ray = question.ray();
  const Surfaces walls = question.walls("walls");
  const std::uint64_t bounces = question.whole("bounces");
  if (bounces > kMostBounces) question.mistake("bounces", "are a million at most");
  if (question.sound() && ray.direction.x() == 0 && ray.direction.y() == 0)
    question.mistake("direction", "is zero: an orbit needs somewhere to go");
  if (!question.sound()) return {};
  const std::vector<Material> mirrors(walls.size(), Material::mirror);
  const Orbit orbit = trace_orbit(walls, mirrors, ray, bounces);
  Values numbers, points, corner;
  for (const Bounce& bounce : orbit.bounces) {
    numbers.emplace_back(bounce.surface);
    points.push_back(as_json(bounce.point));
  }
  Fields fields = {{"walls", std::move(numbers)},
                   {"points", std::move(points)},
                   {"end", name(orbit.end)},
                   {"out", orbit.end == OrbitEnd::escape ? as_json(orbit.out) : JsonValue()}};
  if (orbit.end == OrbitEnd::corner) {
    for (const std::uint32_t wall : orbit.end_surfaces) corner.emplace_back(wall);
    fields.emplace_back("corner", as_json(orbit.end_point));
    fields.emplace_back("corner_walls", std::move(corner));
  }
  fields.emplace_back("certain", proven_bounces(walls, orbit));
  return fields;
}

}  // namespace

extern const Query orbit = {"orbit", "the bounces of a ray between mirrors", &answer};

}  // namespace flatray::queries
