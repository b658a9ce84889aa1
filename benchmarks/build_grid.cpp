// How long does it take to build the cells of a scene, on one thread and more? CPU seconds of the
// calling thread, which waits for none of the others, and wall seconds beside them.
#include <fmt/core.h>

#include "measure.h"
#include "trace/cells.h"
#include "trace_scenes.h"

int main() {
  fmt::print("{:>9} {:>10} {:>8} {:>14} {:>14}\n", "segments", "layout", "threads", "own CPU, ms",
             "wall, ms");
  for (const std::size_t count : {4096UL, 65536UL, 1048576UL})
    for (const bench::Layout& layout : {bench::kUniform, bench::kPower6}) {
      const bench::Room room = bench::room(count, layout);
      std::vector<bench::Contender> contenders;
      const unsigned widths[] = {1, 2};
      for (const unsigned threads : widths)
        contenders.push_back({fmt::format("{}", threads), [&room, threads] {
                                (void)flatray::CellGrid::build(room.walls, threads);
                              }});
      const auto own = bench::compare(contenders, 5);
      const auto wall = bench::compare(contenders, 5, 0.05, CLOCK_MONOTONIC);
      for (std::size_t i = 0; i < contenders.size(); ++i)
        fmt::print("{:>9} {:>10} {:>8} {:>14.2f} {:>14.2f}\n", count, layout.name,
                   contenders[i].name, 1e3 * own[i], 1e3 * wall[i]);
    }
}
