// How many rays must a call have before lanes pay? CPU nanoseconds a ray by the size of the batch, as
// a ratio to the largest; 1 is beside what nearest_of_one takes.
#include <fmt/core.h>

#include <cstdlib>

#include "measure.h"
#include "trace/tracer.h"
#include "trace_scenes.h"

namespace {

constexpr std::size_t kRays = 16384;

void measure(std::size_t segments) {
  const bench::Room room = bench::room(segments, bench::kUniform);
  const auto tracer = flatray::find_tracer(segments > 24 ? "grid" : "brute")->build(room.walls);
  const flatray::RayBatch all = bench::random_rays(kRays, room.side, 5);
  const std::size_t sizes[] = {1, 2, 4, 8, 16, 32, 64, 256, 1024, 4096, kRays};
  std::vector<std::vector<flatray::RayBatch>> cut;
  std::vector<flatray::NearestHit> truth(kRays), hits(kRays);
  tracer->nearest(all, truth);
  std::vector<bench::Contender> contenders;
  for (const std::size_t size : sizes) {
    auto& batches = cut.emplace_back(kRays / size);
    for (std::size_t i = 0; i < kRays; ++i) batches[i / size].add(all.ray(i));
  }
  for (std::size_t k = 0; k < cut.size(); ++k)
    contenders.push_back({"", [&, k] {
                            for (std::size_t i = 0; i < cut[k].size(); ++i)
                              tracer->nearest(cut[k][i],
                                              std::span(hits).subspan(i * sizes[k], sizes[k]));
                          }});
  contenders.push_back({"", [&] {
                          for (std::size_t i = 0; i < kRays; ++i)
                            hits[i] = tracer->nearest_of_one(all.ray(i));
                        }});
  for (const bench::Contender& one : contenders) {
    one.run();
    if (hits == truth) continue;
    fmt::print("answers differ\n");
    std::exit(1);
  }
  const auto seconds = bench::compare(contenders, 7, 0.01);
  const double largest = seconds[std::size(sizes) - 1];
  for (std::size_t k = 0; k < seconds.size(); ++k)
    fmt::print("{:>8} {:>6} {:>9.1f} {:>7.2f}\n", segments,
               k < std::size(sizes) ? fmt::format("{}", sizes[k]) : "alone",
               1e9 * seconds[k] / kRays, seconds[k] / largest);
}

}  // namespace

int main() {
  fmt::print("{:>8} {:>6} {:>9} {:>7}\n", "walls", "batch", "ns a ray", "ratio");
  for (const std::size_t segments : {16UL, 256UL, 4096UL, 65536UL}) measure(segments);
}
