#pragma once
#include <cstddef>
#include <functional>

namespace flatray {

/// Runs `task(i)` for every i in [0, count), in any order, on `threads` threads (the caller is one
/// of them), or on fewer where the machine does not give so many.
///
/// Needs   tasks that write to disjoint places. Work is cut by what it is, never by `threads`, so
///         results do not depend on it.
/// Error   the first exception of a task is thrown to the caller after all threads have stopped.
/// Cost    the pool is started for the call: about 20 us a thread.
void parallel_for(std::size_t count, unsigned threads,
                  const std::function<void(std::size_t)>& task);

/// Threads this machine runs at once, at least 1.
unsigned hardware_threads();

}  // namespace flatray
