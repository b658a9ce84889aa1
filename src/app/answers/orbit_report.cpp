#include "app/answers/orbit_report.h"

#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "app/report/report.h"
#include "base/counted.h"
#include "base/number_text.h"
#include "base/shown_text.h"
#include "geom/hit_interval.h"
#include "precise/certified_orbit.h"
#include "precise/proven_bounces.h"
#include "scene/names.h"
#include "study/rooms/room.h"
#include "transport/exact_origin.h"
#include "transport/orbit_tracer.h"
#include "transport/reflection.h"

namespace flatray {
namespace {

constexpr double kDegreesInRadian = 57.29577951308232;
constexpr std::size_t kMostProven = 10'000;

std::string object_name(const Scene& scene, const SurfaceOwner& owner) {
  const std::string own = owner_name(scene, owner);
  const bool pillar = owner.kind == SurfaceOwner::Kind::pillar;
  return pillar ? chamber_name(scene, owner.index) + "/" + own : own;
}

JsonValue edge_value(const SurfaceOwner& owner) {
  return owner.edge == kNoEdge ? JsonValue("circle") : JsonValue(owner.edge);
}

std::string wall_text(const Scene& scene, const SurfaceOwner& owner) {
  const JsonValue edge = edge_value(owner);
  return fmt::format("{} edge {}", object_name(scene, owner),
                     edge.as_text().value_or(json_text(edge)));
}

std::string walls_text(const Scene& scene, const World& world,
                       const std::vector<std::uint32_t>& surfaces) {
  std::string text;
  for (const std::uint32_t surface : surfaces)
    text += (text.empty() ? "" : " and ") + wall_text(scene, world.owner(surface));
  return text;
}

void tell_start(const OrbitRoom& room, OrbitReport& report) {
  const Vec2& start = report.orbit.start;
  const auto walls = ExactOrigins(room.world.surfaces).walls_at(start);
  const auto holder = room.solids.holder(start);
  const bool in_solid = holder && holder->material != Material::glass;
  report.starts_badly = walls.empty() && (in_solid || !room.solids.in_chamber(start));
  report.start = !walls.empty()        ? "on " + walls_text(room.scene, room.world, walls)
                 : holder              ? "inside " + object_name(room.scene, *holder)
                 : report.starts_badly ? "outside " + chamber_name(room.scene, 0)
                                       : "free";
}

// Of a flight to the next bounce; by its ends where its t is beyond the doubles.
double flight_length(const Orbit& orbit, double t, const Vec2& to, double speed) {
  if (t < std::numeric_limits<double>::max()) return t * speed;
  if (std::ranges::count(orbit.crossings, orbit.bounces.size(), &Crossing::bounces) > 0)
    return kInfinity;
  return size_of(to - (orbit.bounces.empty() ? orbit.start : orbit.bounces.back().point));
}

Orbit as_orbit(CertifiedOrbit exact, const Ray& start) {
  const double speed = Speed(start.direction).length();
  Orbit orbit{static_cast<OrbitStop&>(exact), start.origin, start.direction};
  orbit.crossings = std::move(exact.crossings);
  double length = 0;
  for (const CertifiedOrbit::Bounce& one : exact.bounces) {
    length += flight_length(orbit, one.t, one.point, speed);
    orbit.bounces.push_back({one.surface, one.point, one.t, length, one.normal, speed * one.in,
                             speed * one.out, one.cell});
  }
  if (orbit.end == OrbitEnd::limit && !exact.bounces.empty()) orbit.out = exact.bounces.back().out;
  return orbit;
}

Proven proven(const OrbitRoom& room, const Orbit& orbit) {
  if (orbit.bounces.size() <= kMostProven)
    return proven_bounces(room.world.surfaces, orbit, room.materials);
  Orbit first = orbit;
  first.bounces.resize(kMostProven, orbit.bounces.front());
  return {proven_bounces(room.world.surfaces, first, room.materials).bounces, false};
}

// As the wall sees it.
double incidence(const OrbitReport& report, std::size_t number) {
  Bounce bounce = report.orbit.bounces[number];
  if (report.clock) {
    bounce.in -= report.clock->bounces[number].wall_velocity;
    bounce.out -= report.clock->bounces[number].wall_velocity;
  }
  return bounce.incidence();
}

// Before the first bounce, or after the last.
double speed_of(const Orbit& orbit) {
  return (orbit.bounces.empty() ? orbit.direction : orbit.bounces.back().out).stableNorm();
}

// Of a certified orbit: whether doubles are seen to leave it, as far as it is told.
bool leaves_doubles(const OrbitReport& report) {
  return report.bits > 0 && report.horizon < report.orbit.bounces.size();
}

std::string precision_text(const OrbitReport& report) {
  std::string text = fmt::format(
      "; {} {}{} bits", report.decided ? "certified in" : "all certified, what follows is not by",
      report.decided && report.rational ? "exact numbers of " : "", report.bits);
  if (leaves_doubles(report))
    text += fmt::format(", doubles are noise after {} bounces", report.horizon);
  else if (!report.orbit.bounces.empty())
    text += ", doubles are near all of these bounces";
  return text;
}

// By which it left the room.
const WallHole* hole_of(const OrbitRoom& room, const OrbitReport& report) {
  const std::vector<std::uint32_t>& walls = report.orbit.end_surfaces;
  const SurfaceOwner* owner = walls.empty() ? nullptr : &report.world->owner(walls.front());
  if (report.orbit.end != OrbitEnd::absorbed || owner->hole == kNoEntry) return nullptr;
  return &room.scene.chambers[owner->index].holes[owner->hole];
}

const char* end_text(const OrbitRoom& room, const OrbitReport& report) {
  if (!report.decided) return "undecided";
  return hole_of(room, report) != nullptr ? "hole" : name(report.orbit.end);
}

}  // namespace

OrbitRoom::OrbitRoom(const Scene& of, const FrameState& state)
    : scene(of), world(build_world(of, state)), solids(of, state), window(state.window) {}

Result<OrbitReport> follow_orbit(const OrbitRoom& room, const std::string& name, const Ray& start,
                                 std::uint64_t bounces, const OrbitRequest& request) {
  OrbitReport report{name, &room.world, {}, "", false};
  const auto& walls = room.world.surfaces;
  if (request.certified) {
    FLATRAY_TRY(exact, certified_orbit(walls, start, bounces, {room.materials, request.most_bits}));
    report.bits = exact->bits;
    report.rational = exact->rational;
    report.decided = exact->decided;
    const Orbit plain = trace_orbit(walls, room.materials, start, exact->bounces.size());
    report.horizon = horizon(walls, *exact, plain.bounces);
    report.orbit = as_orbit(std::move(*exact), start);
    report.certain = report.orbit.bounces.size();
    report.certified = true;
    report.end_certain = report.decided;
  } else {
    OrbitRules rules = request.rules;
    rules.glass = &room.glass;
    const OrbitStart from{start, {}, request.chance};
    const OrbitTracer tracer(walls, room.materials, rules);
    report.orbit = std::move(trace_orbits(tracer, std::span(&from, 1), bounces).front());
    report.unproven = rules.field != 0 || room.glass.any();
    const bool exact = (rules.tracer == nullptr || rules.tracer->exact) && !report.unproven;
    const Proven known = exact ? proven(room, report.orbit) : Proven{0, false};
    report.certain = known.bounces;
    report.end_certain = known.end;
  }
  tell_start(room, report);
  return report;
}

OrbitReport follow_moving(const OrbitRoom& room, const MovingWalls& walls, const std::string& name,
                          const Ray& start, double from, const MovingLimits& limits) {
  OrbitReport report{name, &walls.world, {}, "", false};
  MovingOrbit moving = trace_moving_orbit(walls, start, from, limits);
  report.orbit = std::move(moving.orbit);
  report.unproven = true;
  report.clock = {from, moving.end_time, std::move(moving.times)};
  tell_start(room, report);
  return report;
}

namespace {

bool is_periodic(const OrbitRoom& room) {
  return std::ranges::find(room.materials, Material::periodic) != room.materials.end();
}

Values bounce_row(const OrbitRoom& room, const OrbitReport& report, std::size_t i, bool periodic,
                  bool timed) {
  const Bounce& bounce = report.orbit.bounces[i];
  const SurfaceOwner& owner = report.world->owner(bounce.surface);
  Values row{report.ray,
             std::uint64_t{i + 1},
             bounce.t,
             bounce.path_length,
             bounce.point.x(),
             bounce.point.y(),
             object_name(room.scene, owner),
             edge_value(owner),
             bounce.normal.x(),
             bounce.normal.y(),
             incidence(report, i) * kDegreesInRadian,
             report.unproven      ? "unknown"
             : i < report.certain ? "yes"
                                  : "no"};
  if (room.glass.any()) row.emplace_back(bounce.is_refracted() ? "refracted" : "reflected");
  if (periodic) row.insert(row.end(), {bounce.cell.a, bounce.cell.b});
  if (!timed) return row;
  row.push_back(report.clock ? JsonValue(report.clock->bounces[i].time) : JsonValue());
  row.push_back(report.clock ? JsonValue(bounce.out.stableNorm()) : JsonValue());
  return row;
}

}  // namespace

Table bounce_table(const OrbitRoom& room, std::span<const OrbitReport> reports) {
  Table table({"ray", "bounce", "t", "path_length", "x", "y", "object", "edge", "normal_x",
               "normal_y", "incidence_deg", "certain"});
  const bool timed = std::ranges::any_of(
      reports, [](const OrbitReport& report) { return report.clock.has_value(); });
  if (room.glass.any()) table.columns.emplace_back("went");
  const bool periodic = is_periodic(room);
  if (periodic) table.columns.insert(table.columns.end(), {"cell_a", "cell_b"});
  if (timed) table.columns.insert(table.columns.end(), {"time", "speed"});
  table.made = [&room, reports, periodic, timed](const Table::EachRow& each) {
    for (const OrbitReport& report : reports)
      for (std::size_t i = 0; i < report.orbit.bounces.size(); ++i)
        each(bounce_row(room, report, i, periodic, timed));
  };
  return table;
}

JsonValue as_value(const OrbitRoom& room, const OrbitReport& report) {
  const Orbit& orbit = report.orbit;
  const bool stands_somewhere = orbit.end != OrbitEnd::limit && orbit.end != OrbitEnd::escape;
  Fields fields{
      {"ray", report.ray},
      {"start", as_value(orbit.start)},
      {"start_place", report.start},
      {"direction", as_value(orbit.direction)},
      {"precision", report.certified ? "certified" : "double"},
      {"bits", report.bits > 0 ? JsonValue(report.bits) : JsonValue()},
      {"rational", report.rational},
      {"horizon_of_doubles", leaves_doubles(report) ? JsonValue(report.horizon) : JsonValue()},
      {"bounces", bounce_table(room, {&report, 1})},
      {"certain", report.unproven ? JsonValue() : JsonValue(report.certain)},
      {"end_certain", report.unproven ? JsonValue() : JsonValue(report.end_certain)},
      {"end", end_text(room, report)},
      {"out", as_value(orbit.out)},
      {"end_point", stands_somewhere ? as_value(orbit.end_point) : JsonValue()},
      {"end_walls", walls_text(room.scene, *report.world, orbit.end_surfaces)}};
  if (const WallHole* hole = hole_of(room, report)) fields.emplace_back("hole", hole->name);
  if (is_periodic(room)) {
    const auto lattice = PeriodicWalls(room.world.surfaces, room.materials).lattice();
    fields.emplace_back("lattice", Values{as_value(lattice[0]), as_value(lattice[1])});
  }
  if (!report.clock) return fields;
  fields.emplace_back("start_time", report.clock->start);
  fields.emplace_back("end_time", report.clock->end);
  fields.emplace_back("end_speed", speed_of(orbit));
  return fields;
}

std::string status_line(const OrbitRoom& room, const OrbitReport& report) {
  const Orbit& orbit = report.orbit;
  std::string text = fmt::format("{}: {} after {}", report.ray, end_text(room, report),
                                 counted(orbit.bounces.size(), "bounce"));
  if (const WallHole* hole = hole_of(room, report))
    text = fmt::format("{}: left by {} after {}, at {} of {}", report.ray, hole->name,
                       counted(orbit.bounces.size(), "bounce"), point_text(orbit.end_point),
                       walls_text(room.scene, *report.world, orbit.end_surfaces));
  else if (orbit.end == OrbitEnd::absorbed || orbit.end == OrbitEnd::corner)
    text += fmt::format(" at {}, {}", point_text(orbit.end_point),
                        walls_text(room.scene, *report.world, orbit.end_surfaces));
  else if (orbit.end == OrbitEnd::cyclotron)
    text +=
        fmt::format(": from {} it circles freely and meets no wall", point_text(orbit.end_point));
  else if (report.decided)
    text += fmt::format(", leaving along {}", point_text(orbit.out));
  if (!orbit.bounces.empty())
    text += fmt::format(", path length {} to the last bounce",
                        number_text(orbit.bounces.back().path_length));
  if (report.clock)
    text += fmt::format("; speed {} at time {}", number_text(speed_of(orbit)),
                        number_text(report.clock->end));
  else if (report.bits > 0)
    text += precision_text(report);
  else if (report.unproven)
    text += "; how many bounces are certain is unknown " +
            std::string(orbit.field != 0 ? "in a magnetic field" : "where glass splits orbits");
  else if (report.certain < std::min(orbit.bounces.size(), kMostProven))
    text += fmt::format("; only the first {} are certain", report.certain);
  else if (!report.end_certain && orbit.bounces.size() <= kMostProven)
    text += "; that it ends there is not certain";
  if (report.start != "free") text += "; started " + report.start;
  return shown_text(text) + "\n";
}

}  // namespace flatray
