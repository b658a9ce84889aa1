#pragma once
#include <chrono>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "app/interrupt.h"
#include "base/parallel.h"
#include "base/result.h"

namespace flatray {

/// Chunks 0 to `chunks` - 1 that are `open(chunk)`, a round of `threads` at a time, until
/// interrupted; what `work(chunk)` gives is kept by `keep(chunk, given, seconds)`, in order, when
/// the round is over.
///
/// Cost    memory of a round, whatever the number of chunks.
template <class Open, class Work, class Keep>
Result<void> in_rounds(std::uint64_t chunks, unsigned threads, const Open& open, const Work& work,
                       const Keep& keep) {
  std::uint64_t next = 0;
  while (!interrupted()) {
    std::vector<std::uint64_t> round;
    for (; next < chunks && round.size() < threads; ++next)
      if (open(next)) round.push_back(next);
    if (round.empty()) break;
    std::vector<std::invoke_result_t<Work, std::uint64_t>> given(round.size());
    const auto start = std::chrono::steady_clock::now();
    parallel_for(round.size(), threads, [&](std::size_t i) { given[i] = work(round[i]); });
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    const double seconds = time.count() / static_cast<double>(round.size());
    for (std::size_t i = 0; i < round.size(); ++i)
      if (auto kept = keep(round[i], given[i], seconds); !kept) return kept;
  }
  return {};
}

}  // namespace flatray
