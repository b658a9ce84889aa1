#include "transport/orbit.h"

#include "app/query/periodic_cell.h"
#include "app/query/query.h"
#include "app/report/report.h"
#include "precise/certified_orbit.h"
#include "precise/proven_bounces.h"

namespace flatray::orbit_query {
namespace {

constexpr std::uint64_t kMostBounces = 1'000'000;  // an answer is one line in memory

// Of either kind of orbit: what is the same.
template <class Path>
Fields path(const QuestionRoom& room, const Path& orbit, const char* end) {
  Values numbers, points, cells;
  const PeriodicWalls periodic(room.walls, room.materials);
  for (const auto& bounce : orbit.bounces) {
    numbers.emplace_back(room.numbers[bounce.surface]);
    points.push_back(as_value(bounce.point));
    if (periodic.any()) cells.push_back(Values{bounce.cell.a, bounce.cell.b});
  }
  const bool escapes = orbit.end == OrbitEnd::escape;
  Fields fields{{"walls", std::move(numbers)},
                {"points", std::move(points)},
                {"end", end},
                {"out", escapes ? as_value(orbit.out) : JsonValue()}};
  if (orbit.end == OrbitEnd::corner) {
    Values corner_walls;
    for (const std::uint32_t wall : orbit.end_surfaces)
      corner_walls.emplace_back(room.numbers[wall]);
    fields.emplace_back("corner", as_value(orbit.end_point));
    fields.emplace_back("corner_walls", std::move(corner_walls));
  }
  if (!periodic.any()) return fields;
  fields.emplace_back("cells", std::move(cells));
  fields.emplace_back("lattice",
                      Values{as_value(periodic.lattice()[0]), as_value(periodic.lattice()[1])});
  return fields;
}

Fields in_doubles(const QuestionRoom& room, const Ray& ray, std::uint64_t bounces,
                  const Tracer* tracer) {
  const Orbit orbit =
      trace_orbit(room.walls, room.materials, ray, bounces, {CornerRule::stop, tracer});
  Fields fields = path(room, orbit, name(orbit.end));
  const bool exact = tracer == nullptr || tracer->exact;
  fields.emplace_back("certain", exact ? proven_bounces(room.walls, orbit, room.materials).bounces
                                       : std::uint64_t{0});
  return fields;
}

Fields certified(const QuestionRoom& room, const Ray& ray, std::uint64_t bounces,
                 Question& question) {
  const auto orbit =
      certified_orbit(room.walls, ray, bounces, {room.materials, question.precision().most_bits});
  if (!orbit) {
    question.mistake("precision", orbit.error().front().message);
    return {};
  }
  Fields fields = path(room, *orbit, orbit->decided ? name(orbit->end) : "undecided");
  fields.emplace_back("certain", std::uint64_t{orbit->bounces.size()});
  if (orbit->bits > 0) fields.emplace_back("bits", orbit->bits);
  if (orbit->rational) fields.emplace_back("rational", true);
  return fields;
}

Fields answer(Question& question) {
  const Ray ray = question.ray();
  Surfaces walls = question.walls("walls");
  const QuestionRoom room = question.has("cell") ? periodic_room(question, std::move(walls))
                                                 : plain_room(std::move(walls));
  const std::uint64_t bounces = question.whole("bounces");
  if (bounces > kMostBounces) question.mistake("bounces", "are a million at most");
  if (question.sound() && is_zero(ray.direction))
    question.mistake("direction", "is zero: an orbit needs somewhere to go");
  if (question.sound() && !is_in_cell(room, ray.origin))
    question.mistake("origin", "lies outside the cell");
  if (!question.sound()) return {};
  return question.precision().certified
             ? certified(room, ray, bounces, question)
             : in_doubles(room, ray, bounces, question.precision().tracer);
}

}  // namespace

extern const Query entry = {"orbit", "the bounces of a ray between mirrors", &answer};

}  // namespace flatray::orbit_query
