#include "study/accuracy/timed.h"

#include <algorithm>
#include <cstdint>

namespace flatray {
namespace {

constexpr std::uint64_t kMostRuns = 1 << 16;
constexpr double kLong = 1e-3;

}  // namespace

double seconds_of(const std::function<void()>& work, double (*clock)(), double least) {
  for (std::uint64_t runs = 1;; runs *= 2) {
    const double start = clock();
    for (std::uint64_t run = 0; run < runs; ++run) work();
    const double taken = clock() - start;
    if (taken >= least || runs >= kMostRuns) return taken / static_cast<double>(runs);
  }
}

double least_seconds_of(int times, const std::function<void()>& work, double (*clock)(),
                        double least) {
  double found = seconds_of(work, clock, least);
  for (int i = 1; i < times && found < kLong; ++i)
    found = std::min(found, seconds_of(work, clock, least));
  return found;
}

}  // namespace flatray
