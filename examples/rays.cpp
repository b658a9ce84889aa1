// A fan of rays inside a square with a round pillar: which wall each ray meets first, and where.
// Prints one line a ray. The ray to the right meets the pillar at t = 3, the one to the left the
// wall x = 0 at t = 4, and the one straight up the wall y = 8 at t = 4.
#include <flatray/trace.h>

#include <cstdio>
#include <utility>
#include <vector>

namespace fr = flatray::api;

int main() {
  fr::Walls walls;
  const std::vector<double> x = {0, 8, 8, 0}, y = {0, 0, 8, 8};     // walls 0 to 3
  const double pillar_x[] = {8}, pillar_y[] = {4}, radius[] = {1};  // wall 4
  if (const fr::Status added = walls.add_ring(x, y); !added) {
    std::printf("%s, at entry %zu\n", fr::words(added.fault), added.entry);
    return 1;
  }
  if (!walls.add_circles(pillar_x, pillar_y, radius)) return 1;
  const fr::RayTracer tracer(std::move(walls));

  const std::vector<double> ox(3, 4), oy(3, 4), dx = {1, -1, 0}, dy = {0, 0, 1};
  std::vector<fr::Hit> hits(ox.size());
  if (!tracer.nearest({ox, oy, dx, dy}, hits)) return 1;
  for (std::size_t i = 0; i < hits.size(); ++i)
    std::printf("ray %zu meets wall %u at t = %.17g\n", i, hits[i].wall, hits[i].t);

  // Is anything in the way within t = 3.5?
  const std::vector<double> up_to(3, 3.5);
  std::vector<std::uint8_t> met(3);
  if (!tracer.any({ox, oy, dx, dy}, up_to, met)) return 1;
  return hits[0].wall == 4 && hits[0].t == 3 && hits[1].wall == 3 && hits[1].t == 4 &&
                 hits[2].wall == 2 && hits[2].t == 4 && met[0] == 1 && met[1] == 0 && met[2] == 0
             ? 0
             : 1;
}
