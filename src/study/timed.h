#pragma once
#include <functional>

namespace flatray {

/// Seconds by `clock` that `work` takes: of as many runs, twice as many each time, as take `least`,
/// the mean.
double seconds_of(const std::function<void()>& work, double (*clock)(), double least);

}  // namespace flatray
