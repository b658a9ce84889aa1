#include <fmt/core.h>

#include <algorithm>

#include "anim/rays.h"
#include "app/answers/measure.h"
#include "collide/scene_timeline.h"
#include "render/ray_walls.h"

namespace flatray {
namespace {

constexpr std::uint64_t kMostBounces = 1000;

struct WallTests {
  std::uint64_t flights = 0, tested = 0, hit = 0;

  void add(const Accelerator& walls, const Ray& ray, const DepartedSurface& departed) {
    ++flights;
    tested += walls.tested_of_one(ray, departed);
  }
};

}  // namespace

Result<Savings> measured_walls(const RenderJob& job) {
  if (!need_of_ray_walls(job.scene).needed || job.scene.field() != 0 || job.frames.empty())
    return Savings();
  FLATRAY_TRY(timeline, make_timeline(job.scene, job.seed, job.last_frame));
  const FrameState state = at(*timeline, job.frames.front());
  const RayWalls walls(job.scene, state, job.tracer);
  const std::size_t count = walls.world().surfaces.size();
  if (count == 0) return Savings();
  WallTests tests;
  for (const RayState& now : ray_states(job.scene, state)) {
    const RayPath& ray = job.scene.rays[now.ray];
    if (ray.speed) continue;
    const Ray& start = now.start;
    const Orbit orbit = trace_orbits(walls.orbits(), std::span(&start, 1),
                                     std::min<std::uint64_t>(ray.bounces, kMostBounces) + 1)
                            .front();
    Ray flight = start;
    DepartedSurface departed;
    for (const Bounce& bounce : orbit.bounces) {
      tests.add(walls.orbits().walls(), flight, departed);
      flight = {bounce.point, bounce.out};
      departed = {bounce.surface, Root::both};
    }
    if (orbit.end != OrbitEnd::limit) tests.add(walls.orbits().walls(), flight, departed);
    tests.hit += orbit.bounces.size() + (orbit.end == OrbitEnd::absorbed ? 1 : 0);
  }
  const auto all = static_cast<double>(count * tests.flights);
  return Savings{
      {"measured: walls tested",
       fmt::format("{:.3g} a flight",
                   static_cast<double>(tests.tested) / static_cast<double>(tests.flights)),
       fmt::format("{:.3g} % of the walls, {} in all, tested and {:.3g} % hit; flights of rays: {}",
                   100 * static_cast<double>(tests.tested) / all, count,
                   100 * static_cast<double>(tests.hit) / all, tests.flights)}};
}

}  // namespace flatray
