#include "study/statistics/blocks.h"

#include <fmt/core.h>

#include <map>
#include <mutex>
#include <utility>

#include "base/counted.h"
#include "base/parallel.h"

namespace flatray {
Result<void> fold_blocks(const ExperimentContext& context, std::size_t count,
                         const std::function<Numbers(std::size_t)>& task,
                         const std::function<void(Numbers&&)>& take) {
  RunMonitor silent;
  RunMonitor& monitor = context.monitor != nullptr ? *context.monitor : silent;
  std::mutex mutex;
  std::map<std::size_t, Numbers> early;  // results whose turn has not come
  std::size_t next = 0, there = 0;
  monitor.begin(count);
  parallel_for(count, context.threads, [&](std::size_t block) {
    auto known = monitor.kept(block);
    if (!known && monitor.stopped()) return;
    Numbers result = known ? std::move(*known) : task(block);
    monitor.done(block, result);
    const std::lock_guard lock(mutex);
    early.emplace(block, std::move(result));
    ++there;
    for (; !early.empty() && early.begin()->first == next; ++next)
      take(std::move(early.extract(early.begin()).mapped()));
  });
  if (there == count) return {};
  return fail(context.scene.where,
              fmt::format("stopped after {} of {}", there, counted(count, "block")));
}

Result<std::vector<Numbers>> run_blocks(const ExperimentContext& context, std::size_t count,
                                        const std::function<Numbers(std::size_t)>& task) {
  std::vector<Numbers> results;
  FLATRAY_TRY(ran, fold_blocks(context, count, task,
                               [&](Numbers&& result) { results.push_back(std::move(result)); }));
  return results;
}

Numbers numbers_of(const SumList& sums) {
  Numbers all;
  for (const double* one : sums) all.push_back(*one);
  return all;
}

void add(const SumList& sums, std::span<const double> numbers) {
  for (std::size_t i = 0; i < sums.size(); ++i) *sums[i] += numbers[i];
}

Result<void> run_tasks(const ExperimentContext& context, std::size_t count,
                       const std::function<void(std::size_t)>& task) {
  const auto run = [&](std::size_t i) {
    task(i);
    return Numbers();
  };
  return fold_blocks(context, count, run, [](const Numbers&) {});
}

}  // namespace flatray
