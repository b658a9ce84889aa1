#include "study/rooms/followed.h"

#include <algorithm>
#include <cmath>

#include "base/counted.h"
#include "base/parallel.h"
#include "precise/certified_orbit.h"

namespace flatray {
namespace {

constexpr std::uint64_t kAuditedOrbits = 64;
constexpr std::uint64_t kAuditedBounces = 60;
// What a certified orbit of the audit may take: more tells little, and could take minutes.
constexpr unsigned kAuditedBits = 2048;
constexpr std::uint64_t kAuditedWork = std::uint64_t{1} << 22;
// Of the room, and less where the next flight is longer than that: an orbit as near to the certified
// one meets the same wall next, unless it passes an end or a tangent as near.
constexpr double kSamePlace = 0x1p-32;
// Of a first flight, in units of 2^-53 of the room, times the cosine of the incidence: the start of
// the flight on its wall, the point met and the wall's own numbers are some ulps off each. Of a flight
// through many cells each rounds its length once more.
constexpr double kRoundingOfFlight = 64;

void follow_certified(const Room& room, const OrbitStart& start, std::size_t number,
                      std::uint64_t bounces, OrbitSink& sink) {
  const auto orbit = certified_orbit(room.walls(), start.ray, bounces, {room.materials()});
  if (!orbit) return sink.end(number, {});
  const double speed = std::sqrt(start.ray.direction.squaredNorm());
  double length = 0;
  auto crossing = orbit->crossings.begin();
  for (std::size_t i = 0; i <= orbit->bounces.size(); ++i) {
    for (; crossing != orbit->crossings.end() && crossing->bounces == i; ++crossing)
      sink.cross(number, crossing->from, crossing->to, crossing->step);
    if (i == orbit->bounces.size()) break;
    const CertifiedOrbit::Bounce& one = orbit->bounces[i];
    length += one.t * speed;
    sink.bounce(number,
                {one.surface, one.point, one.t, length, one.normal, one.in, one.out, one.cell});
  }
  sink.end(number, {orbit->end, orbit->out, orbit->end_point, orbit->end_surfaces});
}

// One start, followed three times.
struct Followed {
  std::size_t proven = 0;                         // bounces of the certified orbit
  std::uint64_t fast_right = 0, exact_right = 0;  // bounces as its own
  bool wrong = false;  // fast left it though it was still at the same place
  double first = 0;    // how much first flights differ
};

Followed follow_thrice(const FastOrbits& orbits, const Room& room, const OrbitStart& start,
                       std::uint64_t bounces, double size) {
  const auto bounces_by = [&](const auto& tracer) {
    std::vector<Bounce> all;
    BounceSink sink([&](std::size_t, const Bounce& bounce) { all.push_back(bounce); });
    tracer.follow(std::span(&start, 1), bounces, sink);
    return all;
  };
  const std::vector<Bounce> fast = bounces_by(orbits), exact = bounces_by(room.orbits());
  const auto truth = certified_orbit(room.walls(), start.ray, bounces,
                                     {room.materials(), kAuditedBits, kAuditedWork});
  Followed found;
  if (!truth || truth->bounces.empty()) return found;
  found.proven = truth->bounces.size();
  found.fast_right = horizon(room.walls(), *truth, fast);
  found.exact_right = horizon(room.walls(), *truth, exact);
  const std::uint64_t right = found.fast_right;
  const double speed = std::sqrt(start.ray.direction.squaredNorm());
  if (right < found.proven) {
    const double flights = std::max(1.0, truth->bounces[right].t * speed / size);
    found.wrong = right == 0 || (fast[right - 1].point - truth->bounces[right - 1].point).norm() <
                                    kSamePlace * size / flights;
  }
  if (right > 0) {
    const CertifiedOrbit::Bounce& first = truth->bounces.front();
    const double t = first.t * speed;
    found.first = std::fabs(fast.front().t - t) * std::fabs(first.in.dot(first.normal)) /
                  (0x1p-53 * size * std::max(1.0, (t / size) * (t / size)));
  }
  return found;
}

}  // namespace

void follow_starts(const ExperimentContext& context, const Room& room,
                   std::span<const OrbitStart> starts, std::uint64_t bounces, OrbitSink& sink) {
  if (context.precision == OrbitPrecision::exact)
    return room.orbits().follow(starts, bounces, sink);
  if (context.precision == OrbitPrecision::fast) {
    room.fast_orbits().follow(starts, bounces, sink);
    return;
  }
  for (std::size_t i = 0; i < starts.size(); ++i)
    follow_certified(room, starts[i], i, bounces, sink);
}

void follow_drawn(const ExperimentContext& context, const Room& room, std::uint64_t begin,
                  std::uint64_t end, std::uint64_t bounces, OrbitSink& sink) {
  std::vector<OrbitStart> starts;
  for (std::uint64_t i = begin; i < end; ++i)
    starts.push_back(room.draw_start(context.seed, i, context.starts));
  follow_starts(context, room, starts, bounces, sink);
}

std::vector<OrbitStart> audited_starts(
    const ExperimentContext& context, std::uint64_t orbits,
    const std::function<std::optional<OrbitStart>(std::uint64_t)>& start) {
  std::vector<OrbitStart> starts;
  if (context.precision != OrbitPrecision::fast) return starts;
  const std::uint64_t count = std::min(orbits, kAuditedOrbits);
  for (std::uint64_t i = 0; i < count; ++i)
    if (const auto one = start(i * (orbits / count))) starts.push_back(*one);
  return starts;
}

std::vector<Measure> audit(const ExperimentContext& context, const Room& room,
                           const OrbitPlan& plan) {
  const auto drawn = [&](std::uint64_t i) {
    return room.draw_start(context.seed, i, context.starts);
  };
  return audit(context, room, audited_starts(context, plan.orbits, drawn), plan.bounces);
}

std::vector<Measure> audit(const ExperimentContext& context, const Room& room,
                           std::span<const OrbitStart> starts, std::uint64_t bounces) {
  if (context.precision != OrbitPrecision::fast) return {};
  return audit_of(room.fast_orbits(), context, room, starts, bounces);
}

std::vector<Measure> audit_of(const FastOrbits& orbits, const ExperimentContext& context,
                              const Room& room, std::span<const OrbitStart> starts,
                              std::uint64_t bounces) {
  if (const std::string& why = orbits.obstacle(); !why.empty())
    return {remarked("audit_orbits", 0, "all orbits are exact: " + why)};
  if (!can_certify())
    return {remarked("audit_orbits", 0, "no audit: the module of certified orbits is not there")};
  const std::uint64_t limit = std::min(bounces, kAuditedBounces);
  const double size = bounds_of(room.walls()).size().maxCoeff();
  std::vector<Followed> all(std::min<std::size_t>(starts.size(), kAuditedOrbits));
  parallel_for(all.size(), context.threads, [&](std::size_t i) {
    if (context.stopped()) return;
    all[i] = follow_thrice(orbits, room, starts[i * (starts.size() / all.size())], limit, size);
  });
  double proven = 0, fast = 0, exact = 0, wrong = 0, first = 0;
  for (const Followed& one : all) {
    proven += static_cast<double>(one.proven);
    fast += static_cast<double>(one.fast_right);
    exact += static_cast<double>(one.exact_right);
    wrong += one.wrong ? 1 : 0;
    first = std::max(first, one.first);
  }
  const auto count = static_cast<double>(all.size());
  return {
      remarked("audit_orbits", count, "followed fast, exactly and certified from the same start"),
      remarked("audit_bounces_certified", proven / count,
               "of an orbit, at most " + counted(limit, "bounce")),
      remarked("audit_bounces_right_fast", fast / count,
               "on the walls of the certified one, within 1 % of the room"),
      {"audit_bounces_right_exact", exact / count},
      expected_within("audit_parted_at_once", wrong, 0, 0,
                      "from within 2^-32 of the room, which rounding does not explain"),
      expected_within("audit_first_flight", first, 0, kRoundingOfFlight,
                      "largest difference, 2^-53 of the room")};
}

}  // namespace flatray
