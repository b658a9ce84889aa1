#include "transport/orbit.h"

#include "app/query/query.h"
#include "geom/clip_range.h"
#include "precise/certified_orbit.h"
#include "precise/proven_bounces.h"

namespace flatray::queries {
namespace {

constexpr std::uint64_t kMostBounces = 1'000'000;  // an answer is one line in memory

JsonValue as_json(const Vec2& point) { return Values{point.x(), point.y()}; }

// Of either kind of orbit: what is the same.
template <class Bounces>
Fields path(const Bounces& bounces, const char* end, JsonValue out) {
  Values numbers, points;
  for (const auto& bounce : bounces) {
    numbers.emplace_back(bounce.surface);
    points.push_back(as_json(bounce.point));
  }
  return {{"walls", std::move(numbers)},
          {"points", std::move(points)},
          {"end", end},
          {"out", std::move(out)}};
}

void add_corner(Fields& fields, const Vec2& corner, const std::vector<std::uint32_t>& walls) {
  fields.emplace_back("corner", as_json(corner));
  fields.emplace_back("corner_walls", Values(walls.begin(), walls.end()));
}

Fields in_doubles(const Surfaces& walls, const Ray& ray, std::uint64_t bounces,
                  const Tracer* tracer) {
  const std::vector<Material> mirrors(walls.size(), Material::mirror);
  const Orbit orbit = trace_orbit(walls, mirrors, ray, bounces, {CornerRule::stop, tracer});
  const bool escapes = orbit.end == OrbitEnd::escape;
  Fields fields = path(orbit.bounces, name(orbit.end), escapes ? as_json(orbit.out) : JsonValue());
  if (orbit.end == OrbitEnd::corner) add_corner(fields, orbit.end_point, orbit.end_surfaces);
  const bool exact = tracer == nullptr || tracer->exact;
  fields.emplace_back("certain", exact ? proven_bounces(walls, orbit).bounces : std::uint64_t{0});
  return fields;
}

Fields certified(const Surfaces& walls, const Ray& ray, std::uint64_t bounces, Question& question) {
  const auto orbit = certified_orbit(walls, ray, bounces, {{}, question.precision().most_bits});
  if (!orbit) {
    question.mistake("precision", orbit.error().front().message);
    return {};
  }
  const bool escapes = orbit->end == OrbitEnd::escape;
  Fields fields = path(orbit->bounces, orbit->decided ? name(orbit->end) : "undecided",
                       escapes ? as_json(orbit->out) : JsonValue());
  if (orbit->end == OrbitEnd::corner) add_corner(fields, orbit->end_point, orbit->end_surfaces);
  fields.emplace_back("certain", std::uint64_t{orbit->bounces.size()});
  if (orbit->bits > 0) fields.emplace_back("bits", orbit->bits);
  if (orbit->rational) fields.emplace_back("rational", true);
  return fields;
}

Fields answer(Question& question) {
  const Ray ray = question.ray();
  const Surfaces walls = question.walls("walls");
  const std::uint64_t bounces = question.whole("bounces");
  if (bounces > kMostBounces) question.mistake("bounces", "are a million at most");
  if (question.sound() && is_zero(ray.direction))
    question.mistake("direction", "is zero: an orbit needs somewhere to go");
  if (!question.sound()) return {};
  return question.precision().certified
             ? certified(walls, ray, bounces, question)
             : in_doubles(walls, ray, bounces, question.precision().tracer);
}

}  // namespace

extern const Query orbit = {"orbit", "the bounces of a ray between mirrors", &answer};

}  // namespace flatray::queries
