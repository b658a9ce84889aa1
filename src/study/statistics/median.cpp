#include "study/statistics/median.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace flatray {

MedianInterval median_interval(std::vector<double> values, double confidence) {
  FLATRAY_CHECK(!values.empty());
  std::ranges::sort(values);
  const std::size_t count = values.size(), middle = count / 2;
  // Of `count` draws, `chance` is that of exactly `below` on one side of the median, `beyond` of no
  // more.
  double chance = std::ldexp(1.0, -static_cast<int>(count)), beyond = chance;
  std::size_t below = 0;
  while (2 * (below + 1) < count) {
    const double next =
        chance * static_cast<double>(count - below) / static_cast<double>(below + 1);
    if (1 - 2 * (beyond + next) < confidence) break;
    chance = next;
    beyond += next;
    ++below;
  }
  const double median =
      count % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
  return {median, values[below], values[count - 1 - below], 1 - 2 * beyond};
}

}  // namespace flatray
