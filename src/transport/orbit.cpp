#include "transport/orbit.h"

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"
#include "transport/orbit_tracer.h"
#include "transport/reflection.h"

namespace flatray {
namespace {

class OrbitKeeper : public OrbitSink {
 public:
  OrbitKeeper(std::span<const OrbitStart> starts, double field) : orbits_(starts.size()) {
    for (std::size_t i = 0; i < starts.size(); ++i) {
      orbits_[i].start = starts[i].ray.origin;
      orbits_[i].direction = starts[i].ray.direction;
      orbits_[i].field = field;
    }
  }
  void bounce(std::size_t number, const Bounce& bounce) override {
    orbits_[number].bounces.push_back(bounce);
  }
  void cross(std::size_t number, const Vec2& from, const Vec2& to, const CellIndex& step) override {
    Orbit& orbit = orbits_[number];
    orbit.crossings.push_back({orbit.bounces.size(), from, to, step});
  }
  void end(std::size_t number, const OrbitStop& stop) override {
    static_cast<OrbitStop&>(orbits_[number]) = stop;
  }
  std::vector<Orbit> orbits() && { return std::move(orbits_); }

 private:
  std::vector<Orbit> orbits_;
};

// Adds a flight of an orbit from a point in a direction to another.
void add_flight(std::vector<OrbitLine>& lines, double field, const Ray& flight, const Vec2& to,
                bool reflected) {
  Vec2 last = flight.origin;
  if (field != 0)
    for (const Vec2& point : points_between(field, flight, to)) {
      lines.push_back({{last, point}, false});
      last = point;
    }
  lines.push_back({{last, to}, reflected});
}

}  // namespace

const char* name(OrbitEnd end) {
  constexpr const char* kNames[] = {"limit", "escape", "absorbed", "corner", "along", "cyclotron"};
  return kNames[static_cast<std::size_t>(end)];
}

std::vector<std::uint32_t> taken_by(std::span<const Material> materials,
                                    std::span<const std::uint32_t> walls) {
  const auto material = [&](std::uint32_t wall) { return materials[wall]; };
  const auto hole = std::ranges::find(walls, Material::hole, material);
  if (hole != walls.end()) return {*hole};
  if (std::ranges::count(walls, Material::absorb, material) != std::ssize(walls)) return {};
  return {walls.begin(), walls.end()};
}

double Bounce::incidence() const {
  if (out == -in) return 0;  // straight back, or nowhere
  const Vec2 way = Speed(in).near_one(in);
  return portable::atan2(std::fabs(cross(normal, way)), std::fabs(normal.dot(way)));
}

std::vector<OrbitLine> orbit_lines(const Orbit& orbit) {
  std::vector<OrbitLine> lines;
  Vec2 last = orbit.start, direction = orbit.direction;
  auto crossing = orbit.crossings.begin();
  for (std::size_t i = 0; i <= orbit.bounces.size(); ++i) {
    for (; crossing != orbit.crossings.end() && crossing->bounces == i; ++crossing) {
      lines.push_back({{last, crossing->from}, false});
      last = crossing->to;
    }
    if (i == orbit.bounces.size()) break;
    add_flight(lines, orbit.field, {last, direction}, orbit.bounces[i].point, true);
    last = orbit.bounces[i].point;
    direction = orbit.bounces[i].out;
  }
  if (leaves(orbit)) lines.push_back({{last, last + orbit.out}, false});
  if (orbit.end == OrbitEnd::absorbed || orbit.end == OrbitEnd::corner ||
      orbit.end == OrbitEnd::cyclotron)
    add_flight(lines, orbit.field, {last, direction}, orbit.end_point, false);
  return lines;
}

std::vector<Orbit> trace_orbits(const OrbitTracer& tracer, std::span<const OrbitStart> starts,
                                std::uint64_t bounces) {
  OrbitKeeper keeper(starts, tracer.field());
  tracer.follow(starts, bounces, keeper);
  return std::move(keeper).orbits();
}

std::vector<Orbit> trace_orbits(const OrbitTracer& tracer, std::span<const Ray> starts,
                                std::uint64_t bounces) {
  std::vector<OrbitStart> from;
  for (const Ray& start : starts) from.push_back({start});
  return trace_orbits(tracer, from, bounces);
}

std::vector<Orbit> trace_orbits(const Surfaces& walls, std::span<const Material> materials,
                                std::span<const Ray> starts, std::uint64_t bounces,
                                const OrbitRules& rules) {
  return trace_orbits(OrbitTracer(walls, materials, rules), starts, bounces);
}

Orbit trace_orbit(const Surfaces& walls, std::span<const Material> materials, const Ray& start,
                  std::uint64_t bounces, const OrbitRules& rules) {
  return std::move(trace_orbits(walls, materials, std::span(&start, 1), bounces, rules).front());
}

}  // namespace flatray
