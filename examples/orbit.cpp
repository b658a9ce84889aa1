// A ray between mirrors: in a square of side 20 it follows a closed diamond.
// Prints each bounce and why the orbit ended. After 12 bounces it is at (10, 0), and as every
// bounce is a multiple of 5 the places are exact.
#include <flatray/transport.h>

#include <cstdio>
#include <utility>
#include <vector>

namespace fr = flatray::api;

int main() {
  fr::Walls walls;
  const std::vector<double> x = {0, 20, 20, 0}, y = {0, 0, 20, 20};
  if (!walls.add_ring(x, y)) return 1;
  fr::Room room(std::move(walls));

  const std::vector<double> ox = {15}, oy = {5}, dx = {1}, dy = {1};
  std::vector<fr::Orbit> orbits;
  std::vector<fr::Bounce> bounces;
  if (!room.orbits({ox, oy, dx, dy}, 12, orbits, bounces)) return 1;
  for (const fr::Bounce& bounce : bounces)
    std::printf("wall %u at (%.17g, %.17g), %.17g from the start\n", bounce.wall, bounce.x,
                bounce.y, bounce.path_length);
  const bool diamond = orbits[0].reason == fr::OrbitEnd::limit && bounces.size() == 12 &&
                       bounces[11].x == 10 && bounces[11].y == 0 && bounces[11].wall == 0;

  // The same with a wall that absorbs: the first one it meets is the right one, wall 1.
  const std::vector<std::uint32_t> black = {1};
  if (!room.absorb(black) || !room.orbits({ox, oy, dx, dy}, 12, orbits, bounces)) return 1;
  std::printf("absorbed at (%.17g, %.17g)\n", orbits[0].x, orbits[0].y);
  return diamond && orbits[0].reason == fr::OrbitEnd::absorbed && bounces.empty() &&
                 orbits[0].x == 20 && orbits[0].y == 10
             ? 0
             : 1;
}
