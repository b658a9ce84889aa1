// A ray at a convex polygon: one by one, or by lanes of them. Nanoseconds a ray, random lines through
// polygons inscribed in a circle; answers are compared first.
#include <fmt/core.h>

#include <cmath>
#include <cstdlib>

#include "base/philox.h"
#include "geom/clip.h"
#include "geom/polygon.h"
#include "measure.h"
#include "trace/hit_intervals.h"

namespace {

using namespace flatray;

constexpr std::size_t kRays = 256;

// Points of the unit circle; the few that rounding leaves inside their neighbours' chord are dropped.
std::vector<Vec2> circle(std::size_t count) {
  std::vector<Vec2> ring;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(count);
    ring.emplace_back(std::cos(angle), std::sin(angle));
  }
  while (const auto vertex = non_convex_vertex(ring))
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(*vertex));
  return ring;
}

std::vector<Ray> rays() {
  const auto draw = [](std::size_t i, std::uint32_t k) {
    return 3 * unit_double(random_bits(1, Stream::test, 0, i, k)) - 1.5;
  };
  std::vector<Ray> all;
  for (std::size_t i = 0; i < kRays; ++i)
    all.push_back({{draw(i, 0), draw(i, 1)}, {draw(i, 2), draw(i, 3)}});
  return all;
}

}  // namespace

int main() {
  const std::vector<Ray> all = rays();
  RayBatch batch;
  for (const Ray& ray : all) batch.add(ray);
  std::vector<HitInterval> hits(kRays);
  fmt::print("{:>8}{:>12}{:>12}\n", "edges", "loop, ns", "batch, ns");
  for (const std::size_t count : {8, 17, 24, 32, 64, 256, 1024, 4096}) {
    const std::vector<Vec2> ring = circle(count);
    clip_convex_batch(batch, ring, kLine, hits);
    for (std::size_t i = 0; i < kRays; ++i)
      if (hits[i] != clip_convex(all[i], ring, kLine)) return EXIT_FAILURE;
    double sum = 0;
    const auto times =
        bench::compare({{"loop",
                         [&] {
                           for (const Ray& ray : all) sum += clip_convex(ray, ring, kLine).t_exit;
                         }},
                        {"batch", [&] { clip_convex_batch(batch, ring, kLine, hits); }}},
                       9);
    const double ns = 1e9 / static_cast<double>(kRays);
    fmt::print("{:>8}{:>12.0f}{:>12.0f}{}\n", ring.size(), times[0] * ns, times[1] * ns,
               std::isnan(sum) ? " " : "");
  }
}
