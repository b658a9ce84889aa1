// Goal S13: a 1080p sequence by two threads against one, and the memory it takes.
#include <fmt/core.h>

#include <filesystem>

#include "process.h"

namespace {

namespace fs = std::filesystem;

constexpr int kFrames = 96, kRounds = 9;

}  // namespace

int main(int, char** arguments) {
  const fs::path programs = fs::absolute(arguments[0]).parent_path();
  const fs::path folder = fs::temp_directory_path() / fmt::format("sequence.{}", getpid());
  std::vector<double> cpu[2], wall[2];
  double peak[2] = {};
  bool worked = true;
  for (int round = 0; round <= kRounds && worked; ++round)
    for (std::size_t i = 0; i < 2; ++i) {
      const bench::ProcessCost cost =
          bench::run_process({(programs.parent_path() / "flatray").string(), "render", BENCH_SCENE,
                              "--size", "1920x1080", "-f", fmt::format("1..{}", kFrames), "-j",
                              i == 0 ? "1" : "2", "-o", (folder / "frame_####.png").string()});
      worked = worked && cost.worked;
      fs::remove_all(folder);
      peak[i] = std::max(peak[i], cost.peak_mb);
      if (round == 0) continue;
      cpu[i].push_back(cost.cpu);
      wall[i].push_back(cost.wall);
    }
  if (!worked) {
    fmt::print("S13: flatray render failed\n");
    return 1;
  }
  const double one = bench::median(cpu[0]), two = bench::median(cpu[1]);
  const double one_wall = bench::median(wall[0]), two_wall = bench::median(wall[1]);
  fmt::print(
      "\nS13: {} frames of the demo at 1920 x 1080 by `flatray render`, medians of {} rounds in "
      "turn\n"
      "| threads | ms CPU | ms wall | peak MB |\n|---|---|---|---|\n"
      "| 1       | {:6.0f} | {:7.0f} | {:7.1f} |\n| 2       | {:6.0f} | {:7.0f} | {:7.1f} |\n"
      "| two against one     | ratio | must | aim  |\n|---|---|---|---|\n"
      "| sum of CPU rates    | {:5.2f} | 1.8  | 1.95 |\n"
      "| wall                | {:5.2f} | 1.7  | 1.9  |\n",
      kFrames, kRounds, 1e3 * one, 1e3 * one_wall, peak[0], 1e3 * two, 1e3 * two_wall, peak[1],
      2 * one / two, one_wall / two_wall);
}
