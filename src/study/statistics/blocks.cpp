#include "study/statistics/blocks.h"

#include <fmt/core.h>

#include <atomic>

#include "base/counted.h"
#include "base/parallel.h"

namespace flatray {
namespace {

class NoMonitor : public RunMonitor {
 public:
  void begin(std::size_t) override {}
  std::optional<Numbers> kept(std::size_t) override { return std::nullopt; }
  void done(std::size_t, const Numbers&) override {}
  bool stopped() override { return false; }
};

}  // namespace

Result<std::vector<Numbers>> run_blocks(const ExperimentContext& context, std::size_t count,
                                        const std::function<Numbers(std::size_t)>& task) {
  NoMonitor silent;
  RunMonitor& monitor = context.monitor != nullptr ? *context.monitor : silent;
  std::vector<Numbers> results(count);
  std::atomic<std::size_t> finished{0};
  monitor.begin(count);
  parallel_for(count, context.threads, [&](std::size_t block) {
    auto known = monitor.kept(block);
    if (!known && monitor.stopped()) return;
    results[block] = known ? std::move(*known) : task(block);
    monitor.done(block, results[block]);
    ++finished;
  });
  if (finished == count) return results;
  return fail(named_place(context.scene.name),
              fmt::format("stopped after {} of {}", finished.load(), counted(count, "block")));
}

}  // namespace flatray
