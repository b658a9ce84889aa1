#pragma once
#include <functional>

namespace flatray {

/// Seconds by `clock` that `work` takes: of as many runs, twice as many each time, as take `least`,
/// the mean.
double seconds_of(const std::function<void()>& work, double (*clock)(), double least);

/// The least of `times` such measurements, of one where that takes a millisecond: what else the
/// machine does only adds to a time.
double least_seconds_of(int times, const std::function<void()>& work, double (*clock)(),
                        double least);

}  // namespace flatray
