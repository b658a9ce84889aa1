#include "study/stability/leaks.h"

#include <cmath>
#include <numbers>

#include "base/philox.h"
#include "base/portable_math.h"
#include "geom/predicates.h"
#include "study/stability/ulps.h"
#include "trace/exact_nearest.h"
#include "transport/orbit.h"

namespace flatray {
namespace {

constexpr int kCorners = 300, kPillars = 60;
constexpr double kTurn = 2 * std::numbers::pi;
constexpr RoomPlace kPlaces[] = {{"origin", 1, 0, 0},
                                 {"shifted-by-1e6", 1, 1e6, -1e6},
                                 {"scaled-by-1e-5", 1e-5, 0, 0},
                                 {"scaled-by-1e15", 1e15, 0, 0},
                                 {"round", 1, 0, 0, true},
                                 {"round-shifted-by-1e6", 1, 1e6, -1e6, true},
                                 {"round-scaled-by-1e-5", 1e-5, 0, 0, true},
                                 {"round-scaled-by-1e15", 1e15, 0, 0, true}};

class Draw {
 public:
  Draw(std::uint64_t seed, std::uint64_t block) : seed_(seed), block_(block) {}
  double unit() { return unit_double(bits()); }
  std::uint64_t bits() { return random_bits(seed_, Stream::test, block_, next_++); }

 private:
  std::uint64_t seed_, block_, next_ = 0;
};

void add_ring(Surfaces& walls, const RoomPlace& place, const Vec2& centre, double radius,
              int count) {
  if (place.round) {
    walls.add(Circle{place.scale * centre + Vec2(place.x, place.y), place.scale * radius});
    return;
  }
  std::vector<Vec2> ring;
  for (int i = 0; i < count; ++i) {
    const double angle = kTurn * i / count;
    const Vec2 at = centre + radius * Vec2(portable::cos(angle), portable::sin(angle));
    ring.push_back(place.scale * at + Vec2(place.x, place.y));
  }
  for (std::size_t i = 0; i < ring.size(); ++i)
    walls.add(Segment{ring[i], ring[(i + 1) % ring.size()]});
}

// The room first, counter-clockwise; the same pillars in every place.
Surfaces sealed_room(const RoomPlace& place, std::uint64_t seed) {
  Draw draw(seed, ~std::uint64_t{0});
  Surfaces walls;
  add_ring(walls, place, {0, 0}, 1, kCorners);
  for (int i = 0; i < kPillars; ++i) {
    const double x = draw.unit(), y = draw.unit();
    add_ring(walls, place, 0.6 * Vec2(2 * x - 1, 2 * y - 1), 0.01 + 0.04 * draw.unit(), 3 + i % 6);
  }
  return walls;
}

// Towards the end of a wall, or along a tangent from outside; from inside a circle to its centre.
Vec2 aimed(Draw& draw, const Surfaces& walls, const RoomPlace& place, const Vec2& from) {
  if (!place.round) return walls.segments[draw.bits() % walls.segments.size()].a - from;
  const std::uint64_t bits = draw.bits();
  const Circle circle = circle_of(walls.arcs[(bits >> 1) % walls.arcs.size()].curve);
  Vec2 to = circle.centre - from;
  const Vec2 left(-to.y(), to.x());
  const double square = to.squaredNorm() - circle.radius * circle.radius;
  if (!(square > 0)) return to;
  return std::sqrt(square) * to + (bits % 2 == 0 ? 1 : -1) * circle.radius * left;
}

std::vector<Ray> aimed_rays(const Surfaces& walls, const RoomPlace& place, std::uint64_t seed,
                            std::uint64_t block, std::uint64_t count) {
  Draw draw(seed, block);
  std::vector<Ray> rays;
  while (rays.size() < count) {
    const double x = draw.unit(), y = draw.unit();
    const Vec2 from = place.scale * (0.65 * Vec2(2 * x - 1, 2 * y - 1)) + Vec2(place.x, place.y);
    rays.push_back({from, aimed(draw, walls, place, from)});
  }
  return rays;
}

// Also where it has come from one side of a disc to the other.
bool is_outside(const Surfaces& walls, const Vec2& start, const Vec2& point) {
  for (std::size_t i = 0; i < walls.arcs.size(); ++i) {
    const Sign side = side_of(walls.arcs[i], point), before = side_of(walls.arcs[i], start);
    if (side != Sign::zero && side == -(i == 0 ? Sign::negative : before)) return true;
  }
  if (!walls.curve_numbers.empty()) return false;
  for (int i = 0; i < kCorners; ++i) {
    const Segment& wall = walls.segments[static_cast<std::size_t>(i)];
    if (orientation(wall.a, wall.b, point) == Sign::negative) return true;
  }
  return false;
}

void compare_first(const Tracer& tracer, const Surfaces& walls, const std::vector<Ray>& rays,
                   LeakTally& tally) {
  RayBatch batch;
  for (const Ray& ray : rays) batch.add(ray);
  std::vector<NearestHit> truth(rays.size()), hits(rays.size());
  accelerate(walls)->nearest(batch, truth);
  tracer.build(walls)->nearest(batch, hits);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (hits[i].surface != truth[i].surface)
      ++tally.wrong;
    else if (!is_within_ulp(hits[i].t, truth[i].t))
      ++tally.wrong_t;
  }
}

// How far apart points of a scene are that floats just tell from each other, a few roundings on.
double float_grain(const Surfaces& walls) {
  double most = 0;
  for (const Segment& wall : walls.segments) most = std::max(most, wall.a.cwiseAbs().maxCoeff());
  return 0x1p-21 * most;
}

// An answer that is not the exact one, in a straight room.
void classify(const Surfaces& walls, const Ray& ray, const DepartedSurface& departed,
              const NearestHit& truth, const NearestHit& hit, LeakTally& tally) {
  if (!hit) {
    ++tally.nothing;
    return;
  }
  const double grain = float_grain(walls);
  const Segment& first = walls.segments[truth.surface];
  const Segment& other = walls.segments[hit.surface];
  const Vec2 point = ray.origin + truth.t * ray.direction;
  const auto is_near = [&](const Vec2& end) { return (end - point).norm() <= grain; };
  ExactNearest alone(walls, ray, departed, true);
  alone.offer(hit.surface);
  const NearestHit met = alone.hit();
  const bool shared = (is_near(first.a) && (first.a == other.a || first.a == other.b)) ||
                      (is_near(first.b) && (first.b == other.a || first.b == other.b));
  if (shared || (met && met.t == truth.t))
    ++tally.beside;
  else if (!met)
    ++tally.invented;
  else
    ++(is_near(first.a) || is_near(first.b) ? tally.through_end : tally.through);
}

// The rays of exact orbits, asked again.
void compare_all(const Tracer& tracer, const Surfaces& walls, const std::vector<Ray>& rays,
                 LeakTally& tally) {
  const std::vector<Material> mirrors(walls.size(), Material::mirror);
  RayBatch batch;
  for (const Orbit& orbit : trace_orbits(walls, mirrors, rays, kLeakBounces)) {
    batch.add({orbit.start, orbit.direction});
    const bool goes_on = orbit.end == OrbitEnd::escape;
    for (std::size_t i = 0; i + (goes_on ? 0 : 1) < orbit.bounces.size(); ++i)
      batch.add({orbit.bounces[i].point, orbit.bounces[i].out}, {orbit.bounces[i].surface});
  }
  std::vector<NearestHit> truth(batch.size()), hits(batch.size());
  accelerate(walls)->nearest(batch, truth);
  tracer.build(walls)->nearest(batch, hits);
  tally.asked += batch.size();
  for (std::size_t i = 0; i < hits.size(); ++i)
    if (truth[i] && hits[i].surface != truth[i].surface)
      classify(walls, batch.ray(i), batch.departed[i], truth[i], hits[i], tally);
}

}  // namespace

std::span<const RoomPlace> room_places() { return kPlaces; }

void LeakTally::add(const LeakTally& other) {
  for (const auto count : kLeakCounts) this->*count += other.*count;
}

LeakTally count_leaks(const Tracer& tracer, const RoomPlace& place, std::uint64_t seed,
                      std::uint64_t block, std::uint64_t count) {
  const Surfaces walls = sealed_room(place, seed);
  const std::vector<Ray> rays = aimed_rays(walls, place, seed, block, count);
  LeakTally tally;
  tally.rays = rays.size();
  compare_first(tracer, walls, rays, tally);
  if (!tracer.exact && !place.round) compare_all(tracer, walls, rays, tally);
  const std::vector<Material> mirrors(walls.size(), Material::mirror);
  for (const Orbit& orbit :
       trace_orbits(walls, mirrors, rays, kLeakBounces, {CornerRule::stop, &tracer})) {
    tally.bounces += orbit.bounces.size();
    if (orbit.end == OrbitEnd::corner || orbit.end == OrbitEnd::along) ++tally.corners;
    const bool out =
        !orbit.bounces.empty() && is_outside(walls, orbit.start, orbit.bounces.back().point);
    if (orbit.end == OrbitEnd::escape || out) ++tally.leaks;
  }
  return tally;
}

}  // namespace flatray
