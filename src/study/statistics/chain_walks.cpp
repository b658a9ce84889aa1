#include "study/statistics/chain_walks.h"

#include <algorithm>

#include "anim/step.h"
#include "base/parallel.h"
#include "base/philox.h"

namespace flatray {
namespace {

// Enough blocks to keep threads busy, few enough that their counts stay small.
constexpr std::uint64_t kBlocks = 256;

WalkCounts walk_block(const WalkPlan& plan, std::uint64_t begin, std::uint64_t end) {
  WalkCounts counts(plan.chain);
  for (std::uint64_t w = begin; w < end; ++w) {
    StateId state = plan.start;
    std::uint64_t s = 0;
    for (; !plan.absorbing[state] && s < plan.longest; ++s) {
      const StateId next =
          step(plan.chain, state, random_bits(plan.seed, Stream::experiment, s, w, plan.name));
      ++counts.transitions[state][next];
      state = next;
    }
    counts.steps += s;
    counts.unfinished += plan.absorbing[state] ? 0 : 1;
  }
  return counts;
}

}  // namespace

WalkCounts& WalkCounts::operator+=(const WalkCounts& other) {
  steps += other.steps;
  unfinished += other.unfinished;
  for (std::size_t i = 0; i < transitions.size(); ++i)
    for (std::size_t j = 0; j < transitions.size(); ++j)
      transitions[i][j] += other.transitions[i][j];
  return *this;
}

WalkCounts walk(const WalkPlan& plan, unsigned threads) {
  const std::uint64_t size = (plan.walks + kBlocks - 1) / kBlocks;
  std::vector<WalkCounts> blocks(kBlocks, WalkCounts(plan.chain));
  parallel_for(kBlocks, threads, [&](std::size_t b) {
    blocks[b] =
        walk_block(plan, std::min(b * size, plan.walks), std::min((b + 1) * size, plan.walks));
  });
  WalkCounts sum(plan.chain);
  for (const WalkCounts& block : blocks) sum += block;
  return sum;
}

}  // namespace flatray
