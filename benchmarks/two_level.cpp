// Walls that rest and a few that move: is it faster to build the cells of all anew for a frame, or to
// keep those of the resting and ask the moving ones beside them? CPU milliseconds of a frame by how
// many rays it casts.
#include <fmt/core.h>

#include <cstdlib>

#include "measure.h"
#include "trace/cells.h"
#include "trace/tracer.h"
#include "trace_scenes.h"

namespace {

using flatray::NearestHit;
constexpr std::size_t kMoving = 100;

// The nearer of two hits; the moving walls have the higher numbers.
void merge(std::span<NearestHit> resting, std::span<const NearestHit> moving, std::uint32_t first) {
  for (std::size_t i = 0; i < resting.size(); ++i)
    if (moving[i] && moving[i].t < resting[i].t) {
      resting[i] = moving[i];
      resting[i].surface += first;
    }
}

void measure(std::size_t count) {
  const bench::Room room = bench::room(count, bench::kUniform);
  flatray::Surfaces all = room.walls, moving;
  bench::Draws draw(3);
  for (std::size_t i = 0; i < kMoving; ++i) {
    const double x = draw.between(0, room.side), y = draw.between(0, room.side);
    const flatray::Vec2 at(x, y), along = bench::direction(draw.between(0, 6));
    moving.add(flatray::Segment{at, at + along});
    all.add(moving.segments.back());
  }
  const auto first = static_cast<std::uint32_t>(room.walls.size());
  const flatray::Tracer& tracer = *flatray::find_tracer("grid");
  const auto resting = tracer.build(room.walls);
  for (const std::size_t rays : {1000UL, 10000UL, 100000UL, 921600UL}) {
    const flatray::RayBatch batch = bench::random_rays(rays, room.side, 5);
    std::vector<NearestHit> whole(rays), split(rays), other(rays);
    const auto anew = [&] { tracer.build(all)->nearest(batch, whole); };
    const auto kept = [&] {
      const auto of_moving = tracer.build(moving);
      resting->nearest(batch, split);
      of_moving->nearest(batch, other);
      merge(split, other, first);
    };
    anew();
    kept();
    if (whole != split) {
      fmt::print("answers differ\n");
      std::exit(1);
    }
    const auto ms = bench::compare({{"anew", anew}, {"kept", kept}}, 5);
    fmt::print("{:>9} {:>9} {:>12.2f} {:>12.2f}\n", count, rays, 1e3 * ms[0], 1e3 * ms[1]);
  }
}

}  // namespace

int main() {
  fmt::print("{:>9} {:>9} {:>12} {:>12}\n", "resting", "rays", "anew, ms", "kept, ms");
  for (const std::size_t count : {1000UL, 10000UL, 100000UL}) measure(count);
}
