#pragma once
#include <time.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace bench {

/// Seconds of a clock: CLOCK_THREAD_CPUTIME_ID (the thread's own work, whatever else the machine
/// does), CLOCK_PROCESS_CPUTIME_ID, CLOCK_MONOTONIC.
inline double seconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

inline double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

struct Contender {
  std::string name;
  std::function<void()> run;
};

/// Median seconds of one call of each contender. They take turns, round by round, so that what
/// disturbs the machine disturbs all; a turn lasts `turn` seconds or one call. The first round warms
/// up and does not count.
inline std::vector<double> compare(const std::vector<Contender>& contenders, int rounds,
                                   double turn = 0.05, clockid_t clock = CLOCK_THREAD_CPUTIME_ID) {
  std::vector<std::vector<double>> times(contenders.size());
  for (int round = 0; round <= rounds; ++round)
    for (std::size_t i = 0; i < contenders.size(); ++i) {
      const double start = seconds(clock);
      double spent = 0;
      int calls = 0;
      do {
        contenders[i].run();
        ++calls;
        spent = seconds(clock) - start;
      } while (spent < turn);
      if (round > 0) times[i].push_back(spent / calls);
    }
  std::vector<double> medians;
  for (const auto& of_one : times) medians.push_back(median(of_one));
  return medians;
}

}  // namespace bench
