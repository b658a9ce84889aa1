// From how many walls on do cells pay, with their making in it and without? What choose_tracer goes by.
// CPU nanoseconds a ray by brute, grid and exact, as built before, and of brute and grid as built for
// these rays alone.
#include <fmt/core.h>

#include <cstdlib>

#include "measure.h"
#include "trace/tracer.h"
#include "trace_scenes.h"

namespace {

using flatray::NearestHit;

void check(const std::vector<NearestHit>& one, const std::vector<NearestHit>& other) {
  if (one == other) return;
  fmt::print("answers differ\n");
  std::exit(1);
}

void measure(std::size_t segments, std::size_t rays) {
  const bench::Room room = bench::room(segments, bench::kUniform);
  const flatray::RayBatch batch = bench::random_rays(rays, room.side, 5);
  std::vector<NearestHit> truth(rays), hits(rays);
  std::vector<bench::Contender> contenders;
  std::vector<std::unique_ptr<flatray::Accelerator>> built;
  for (const char* name : {"brute", "grid", "exact"}) {
    built.push_back(flatray::find_tracer(name)->build(room.walls));
    const auto& tracer = *built.back();
    if (built.size() == 3 && segments * rays > 4'000'000) break;  // of `exact` some us a pair
    tracer.nearest(batch, built.size() == 1 ? truth : hits);
    if (built.size() > 1) check(truth, hits);
    contenders.push_back({name, [&] { tracer.nearest(batch, hits); }});
  }
  for (const char* name : {"brute", "grid"})
    contenders.insert(contenders.begin() + 2, {name, [&, name] {
                                                 const flatray::Tracer& one =
                                                     *flatray::find_tracer(name);
                                                 one.build(room.walls)->nearest(batch, hits);
                                               }});
  const auto seconds = bench::compare(contenders, 5, 0.01);
  const auto ns = [&](std::size_t i) { return 1e9 * seconds[i] / static_cast<double>(rays); };
  fmt::print("{:>8} {:>7} {:>8.1f} {:>8.1f} {:>9} {:>16.1f} {:>16.1f}\n", segments, rays, ns(0),
             ns(1), seconds.size() > 4 ? fmt::format("{:.0f}", ns(4)) : "", ns(3), ns(2));
  std::fflush(stdout);
}

}  // namespace

int main() {
  fmt::print("{:>8} {:>7} {:>8} {:>8} {:>9} {:>16} {:>16}\n", "walls", "rays", "brute", "grid",
             "exact", "brute with build", "grid with build");
  for (const std::size_t segments : {8UL, 16UL, 20UL, 24UL, 28UL, 32UL, 48UL, 64UL, 256UL})
    measure(segments, 16384);
  for (const std::size_t segments : {256UL, 4096UL, 65536UL})
    for (const std::size_t rays : {1UL, 16UL, 256UL, 4096UL})
      if (segments * rays <= 1UL << 26) measure(segments, rays);
}
