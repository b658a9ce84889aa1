// The part of a ray inside a convex polygon, by Cyrus-Beck clipping, and inside a disc.
// Prints where the ray enters and leaves, and by which edges. The quadrilateral is that of the paper
// "Cyrus Beck Ray Tracing and Dynamic Collision Detection", tables 2 and 3: from 19/72 to 19/27.
#include <flatray/trace.h>

#include <cstdio>
#include <vector>

namespace fr = flatray::api;

int main() {
  const std::vector<double> x = {20, 16, 10, 5}, y = {2, 10, 10, 5};
  const std::vector<double> ox = {1}, oy = {2}, dx = {22}, dy = {10};
  std::vector<fr::Interval> part(1), disc(1);
  if (!fr::clip_convex({ox, oy, dx, dy}, x, y, fr::kRay, part)) return 1;
  std::printf("enters at t = %.17g by edge %d, leaves at t = %.17g by edge %d\n", part[0].enter,
              part[0].edge_enter, part[0].exit, part[0].edge_exit);

  // A disc about the origin of the ray, of the length of its direction: it leaves at t = 1.
  const std::vector<double> along_x = {3}, along_y = {4};
  if (!fr::clip_disc({ox, oy, along_x, along_y}, 1, 2, 5, fr::kRay, disc)) return 1;
  std::printf("inside the disc until t = %.17g\n", disc[0].exit);

  return part[0].enter == 19.0 / 72.0 && part[0].exit == 19.0 / 27.0 && part[0].edge_enter == 3 &&
                 part[0].edge_exit == 0 && disc[0].enter == 0 && disc[0].exit == 1
             ? 0
             : 1;
}
