#pragma once
#include <algorithm>
#include <functional>
#include <span>
#include <type_traits>

#include "study/experiment.h"

namespace flatray {

/// Runs `task` for every block on the threads of the context, but for blocks its monitor has kept.
///
/// Needs   tasks whose numbers depend on their block alone; work cut by what it is, never by
///         threads.
/// Gives   their results by block.
/// Error   when the monitor stops the run.
Result<std::vector<Numbers>> run_blocks(const ExperimentContext& context, std::size_t count,
                                        const std::function<Numbers(std::size_t)>& task);

/// The same, each result given to `take` in the order of the blocks as soon as those before are,
/// and not kept: memory does not grow with the number of blocks.
///
/// Needs   `take` to be called by one thread at a time, whichever.
Result<void> fold_blocks(const ExperimentContext& context, std::size_t count,
                         const std::function<Numbers(std::size_t)>& task,
                         const std::function<void(Numbers&&)>& take);

/// Numbers that blocks add up, where they stand.
using SumList = std::vector<double*>;
/// Adds those of a part: a number, what has append_to() for its own, or a range of such parts.
template <class Part>
void append(SumList& list, Part& part) {
  if constexpr (std::is_same_v<Part, double>)
    list.push_back(&part);
  else if constexpr (requires { part.append_to(list); })
    part.append_to(list);
  else
    for (auto& one : part) append(list, one);
}
/// Those of some parts, one after the other.
template <class... Parts>
SumList sums_of(Parts&... parts) {
  SumList all;
  (append(all, parts), ...);
  return all;
}
Numbers numbers_of(const SumList& sums);
/// Needs   what numbers_of() gives of an equal list.
void add(const SumList& sums, std::span<const double> numbers);

/// The same of tasks that put their results where they belong: a monitor counts them and keeps
/// nothing.
///
/// Needs   an experiment that does not go on from what was kept (ExperimentUses::resume).
Result<void> run_tasks(const ExperimentContext& context, std::size_t count,
                       const std::function<void(std::size_t)>& task);

/// `items` cut into blocks of one size, the last one smaller.
struct Blocks {
  std::uint64_t items, size;

  /// Some hundred blocks of at most 1024 items.
  static Blocks of(std::uint64_t items) {
    return {items, std::clamp<std::uint64_t>(items / 128, 16, 1024)};
  }
  std::size_t count() const { return static_cast<std::size_t>((items + size - 1) / size); }
  std::uint64_t begin(std::size_t block) const { return block * size; }
  std::uint64_t end(std::size_t block) const { return std::min(begin(block) + size, items); }
};

/// Runs `task(begin, end, some)` for every block, items [begin, end), with sums of its own that
/// begin as `sums` do, empty; adds all of them to `sums`, in the order of the blocks. What they are
/// is their `list()`, a SumList.
template <class Sums, class Task>
Result<void> sum_blocks(const ExperimentContext& context, const Blocks& blocks, Sums& sums,
                        const Task& task) {
  const Sums none = sums;
  const SumList all = sums.list();
  return fold_blocks(
      context, blocks.count(),
      [&](std::size_t block) {
        Sums some = none;
        task(blocks.begin(block), blocks.end(block), some);
        return numbers_of(some.list());
      },
      [&](const Numbers& block) { add(all, block); });
}

}  // namespace flatray
