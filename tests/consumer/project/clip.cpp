// Clips one ray against one polygon; exits with 0 where the interval is the exact one.
#include <cstdio>
#include <vector>

#include "geom/cyrus_beck.h"

int main() {
  const std::vector<flatray::Vec2> quad = {{20, 2}, {16, 10}, {10, 10}, {5, 5}};
  const flatray::HitInterval hit = flatray::clip_convex({{1, 2}, {22, 10}}, quad);
  std::printf("enters at t = %.17g, leaves at t = %.17g\n", hit.t_enter, hit.t_exit);
  return hit.t_enter == 19.0 / 72.0 && hit.t_exit == 19.0 / 27.0 ? 0 : 1;
}
