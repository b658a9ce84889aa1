#include "study/chain_walks.h"

#include <algorithm>

#include "anim/step.h"
#include "base/parallel.h"
#include "base/philox.h"

namespace flatray {
namespace {

// Enough blocks to keep threads busy, few enough that their counts stay small.
constexpr std::uint64_t kBlocks = 256;

WalkCounts no_counts(const MarkovChain& chain) {
  const std::size_t states = chain.rows.size();
  return {0, 0, std::vector(states, std::vector<std::uint64_t>(states))};
}

WalkCounts walk_block(const WalkPlan& plan, std::uint64_t begin, std::uint64_t end) {
  WalkCounts counts = no_counts(plan.chain);
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

void add(const WalkCounts& block, WalkCounts& sum) {
  sum.steps += block.steps;
  sum.unfinished += block.unfinished;
  for (std::size_t i = 0; i < sum.transitions.size(); ++i)
    std::transform(sum.transitions[i].begin(), sum.transitions[i].end(),
                   block.transitions[i].begin(), sum.transitions[i].begin(), std::plus<>());
}

}  // namespace

WalkCounts walk(const WalkPlan& plan, unsigned threads) {
  const std::uint64_t size = (plan.walks + kBlocks - 1) / kBlocks;
  std::vector<WalkCounts> blocks(kBlocks);
  parallel_for(kBlocks, threads, [&](std::size_t b) {
    blocks[b] =
        walk_block(plan, std::min(b * size, plan.walks), std::min((b + 1) * size, plan.walks));
  });
  WalkCounts sum = no_counts(plan.chain);
  for (const WalkCounts& block : blocks) add(block, sum);
  return sum;
}

}  // namespace flatray
