// What do two threads that share one set of cells gain? Rays a second by the CPU time of each thread,
// both running, in sum against one alone: a machine with other work tells nothing by its wall time.
#include <fmt/core.h>

#include <thread>

#include "measure.h"
#include "trace/tracer.h"
#include "trace_scenes.h"

namespace {

constexpr std::size_t kRays = 65536;
constexpr int kRounds = 9;

double own_seconds(const flatray::Accelerator& tracer, const flatray::RayBatch& rays) {
  std::vector<flatray::NearestHit> hits(rays.size());
  const double start = bench::seconds(CLOCK_THREAD_CPUTIME_ID);
  for (int i = 0; i < 4; ++i) tracer.nearest(rays, hits);
  return (bench::seconds(CLOCK_THREAD_CPUTIME_ID) - start) / 4;
}

void measure(std::size_t segments) {
  const bench::Room room = bench::room(segments, bench::kUniform);
  const auto tracer = flatray::find_tracer("grid")->build(room.walls);
  const flatray::RayBatch rays = bench::random_rays(kRays, room.side, 5);
  std::vector<double> alone, sums;
  for (int round = 0; round < kRounds; ++round) {
    alone.push_back(kRays / own_seconds(*tracer, rays));
    double rates[2];
    {
      const auto run = [&](double& rate) { rate = kRays / own_seconds(*tracer, rays); };
      std::jthread one(run, std::ref(rates[0])), two(run, std::ref(rates[1]));
    }
    sums.push_back(rates[0] + rates[1]);
  }
  const double one = bench::median(alone), both = bench::median(sums);
  fmt::print("{:>8} {:>10.1f} {:>10.1f} {:>7.2f}\n", segments, 1e-6 * one, 1e-6 * both, both / one);
}

}  // namespace

int main() {
  fmt::print("{:>8} {:>10} {:>10} {:>7}\n", "walls", "one, M/s", "two, M/s", "ratio");
  for (const std::size_t segments : {256UL, 4096UL, 65536UL, 1048576UL}) measure(segments);
}
