#include "study/stability/scale_sweep.h"

#include <cmath>
#include <numbers>

#include "base/portable_math.h"
#include "oracle/families.h"
#include "oracle/nearest.h"
#include "study/stability/ulps.h"

namespace flatray {
namespace {

constexpr int kPolygons = 12, kRays = 48;
constexpr double kFullTurn = 2 * std::numbers::pi;
constexpr int kMost = 1000, kStep = 50;
constexpr std::uint64_t kSweepFamily = 1000;  // names draws that no family has

struct Little {
  Surfaces walls;
  std::vector<Ray> rays;
};

// About the unit square; of the rays a third go exactly from corner to corner.
Little little_room(std::uint64_t seed) {
  oracle::Draw draw(seed, kSweepFamily, 0);
  Little room;
  std::vector<Vec2> corners;
  for (int i = 0; i < kPolygons; ++i) {
    const Vec2 centre = draw.point();
    const double radius = 0.02 + 0.1 * draw.unit(), turn = kFullTurn * draw.unit();
    const int count = 3 + i % 2;
    std::vector<Vec2> ring;
    for (int k = 0; k < count; ++k) {
      const double angle = turn + kFullTurn * k / count;
      ring.push_back(centre + radius * Vec2(portable::cos(angle), portable::sin(angle)));
    }
    for (std::size_t k = 0; k < ring.size(); ++k)
      room.walls.add(Segment{ring[k], ring[(k + 1) % ring.size()]});
    corners.insert(corners.end(), ring.begin(), ring.end());
  }
  for (int i = 0; i < kRays; ++i) {
    const Vec2 from = i % 3 == 0 ? draw.any(corners) : draw.point();
    const Vec2 to = i % 3 == 2 ? draw.point() : draw.any(corners);
    room.rays.push_back({from, to - from});
  }
  return room;
}

// In doubles: where the offset is large most of it is lost, which both sides then see alike.
Little placed(const Little& room, double scale, double offset) {
  const Vec2 moved(offset, offset);
  const auto place = [&](const Vec2& p) -> Vec2 { return scale * p + moved; };
  Little there;
  for (const Segment& wall : room.walls.segments)
    there.walls.add(Segment{place(wall.a), place(wall.b)});
  for (const Ray& ray : room.rays) there.rays.push_back({place(ray.origin), scale * ray.direction});
  return there;
}

bool right_wall(const NearestHit& hit, const oracle::NearestWall& truth) {
  if (!hit || !truth) return static_cast<bool>(hit) == static_cast<bool>(truth);
  return hit.surface == truth.wall;
}

// Needs   the right wall.
bool right_hit(const NearestHit& hit, const oracle::NearestWall& truth) {
  return !hit || (hit.kind == truth.kind && hit.at_end == truth.at_end &&
                  is_within_ulp(hit.t, as_double(truth.t)));
}

}  // namespace

std::vector<double> sweep_steps() {
  std::vector<double> steps;
  for (int step = -kMost; step <= kMost; step += kStep) steps.push_back(step);
  return steps;
}

SweepCell sweep_cell(std::span<const Tracer* const> tracers, std::uint64_t seed, double scale_log2,
                     double offset_log2) {
  const Little room = placed(little_room(seed), std::ldexp(1.0, static_cast<int>(scale_log2)),
                             std::ldexp(1.0, static_cast<int>(offset_log2)));
  SweepCell cell{scale_log2, offset_log2, room.rays.size()};
  RayBatch rays;
  std::vector<oracle::NearestWall> truth;
  for (const Ray& ray : room.rays) {
    rays.add(ray);
    truth.push_back(oracle::nearest_wall(ray, room.walls.segments));
  }
  std::vector<NearestHit> hits(rays.size());
  for (const Tracer* tracer : tracers) {
    tracer->build(room.walls)->nearest(rays, hits);
    std::uint64_t wrong = 0, off = 0;
    for (std::size_t i = 0; i < hits.size(); ++i)
      if (!right_wall(hits[i], truth[i]))
        ++wrong;
      else if (!right_hit(hits[i], truth[i]))
        ++off;
    cell.wrong.push_back(wrong);
    cell.off.push_back(off);
  }
  return cell;
}

}  // namespace flatray
