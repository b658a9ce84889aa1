// Every wall by the textbook formula, in floats and in doubles, beside the exact lanes of `brute`: what
// precision costs, and what it gets wrong. CPU nanoseconds a ray; the share of rays whose wall differs
// from the exact one.
#include <fmt/core.h>

#include "measure.h"
#include "trace/tracer.h"
#include "trace_scenes.h"

namespace {

constexpr std::size_t kRays = 4096;

template <class Real>
struct Edge {
  Real x, y, ex, ey;
};

// The same loop for both; what a compiler makes of it is its business.
template <class Real>
void nearest(const std::vector<Edge<Real>>& edges, const flatray::RayBatch& rays,
             std::vector<std::uint32_t>& walls) {
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const auto x = static_cast<Real>(rays.ox[i]), y = static_cast<Real>(rays.oy[i]);
    const auto dx = static_cast<Real>(rays.dx[i]), dy = static_cast<Real>(rays.dy[i]);
    Real least = std::numeric_limits<Real>::infinity();
    walls[i] = flatray::kNoSurface;
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const Edge<Real>& e = edges[k];
      const Real wx = e.x - x, wy = e.y - y, across = dx * e.ey - dy * e.ex;
      const Real t = (wx * e.ey - wy * e.ex) / across, place = (wx * dy - wy * dx) / across;
      if (!(t >= 0 && place >= 0 && place <= 1 && t < least)) continue;
      least = t;
      walls[i] = static_cast<std::uint32_t>(k);
    }
  }
}

template <class Real>
std::vector<Edge<Real>> edges_of(const flatray::Surfaces& walls) {
  std::vector<Edge<Real>> edges;
  for (const flatray::Segment& s : walls.segments)
    edges.push_back({static_cast<Real>(s.a.x()), static_cast<Real>(s.a.y()),
                     static_cast<Real>(s.b.x() - s.a.x()), static_cast<Real>(s.b.y() - s.a.y())});
  return edges;
}

// Half of the rays at random, half exactly at ends of walls.
flatray::RayBatch rays_of(const bench::Room& room) {
  flatray::RayBatch rays = bench::random_rays(kRays, room.side, 5);
  for (std::size_t i = 0; i < kRays; i += 2) {
    const flatray::Vec2 origin = rays.ray(i).origin;
    rays.set(i, {origin, room.walls.segments[i * 7 % room.walls.size()].a - origin}, {});
  }
  return rays;
}

void measure(std::size_t segments) {
  const bench::Room room = bench::room(segments, bench::kUniform);
  const flatray::RayBatch rays = rays_of(room);
  const auto floats = edges_of<float>(room.walls);
  const auto doubles = edges_of<double>(room.walls);
  const auto exact = flatray::find_tracer("brute")->build(room.walls);
  std::vector<std::uint32_t> by_float(kRays), by_double(kRays);
  std::vector<flatray::NearestHit> hits(kRays);
  const auto seconds = bench::compare({{"", [&] { nearest(floats, rays, by_float); }},
                                       {"", [&] { nearest(doubles, rays, by_double); }},
                                       {"", [&] { exact->nearest(rays, hits); }}},
                                      7, 0.01);
  std::size_t float_wrong = 0, double_wrong = 0;
  for (std::size_t i = 0; i < kRays; ++i) {
    float_wrong += by_float[i] != hits[i].surface ? 1 : 0;
    double_wrong += by_double[i] != hits[i].surface ? 1 : 0;
  }
  const auto ns = [&](std::size_t i) { return 1e9 * seconds[i] / kRays; };
  fmt::print("{:>8} {:>9.1f} {:>9.1f} {:>9.1f} {:>12.1e} {:>12.1e}\n", segments, ns(0), ns(1),
             ns(2), static_cast<double>(float_wrong) / kRays,
             static_cast<double>(double_wrong) / kRays);
}

}  // namespace

int main() {
  fmt::print("{:>8} {:>9} {:>9} {:>9} {:>12} {:>12}\n", "walls", "float", "double", "brute",
             "float wrong", "double wrong");
  for (const std::size_t segments : {16UL, 64UL, 256UL, 1024UL}) measure(segments);
}
