#include "study/statistics/median.h"

#include <algorithm>
#include <numeric>

#include "base/check.h"

namespace flatray {

MedianInterval median_interval(std::vector<double> values, double confidence) {
  FLATRAY_CHECK(!values.empty());
  std::ranges::sort(values);
  const std::size_t count = values.size(), middle = count / 2;
  // The chance of exactly `k` draws below the median, as a part of that of `middle`; it sinks towards 0.
  std::vector<double> chances(middle + 1, 1);
  for (std::size_t k = middle; k-- > 0;)
    chances[k] = chances[k + 1] * static_cast<double>(k + 1) / static_cast<double>(count - k);
  const double lower = std::accumulate(chances.begin(), chances.end() - 1, 0.0);
  const double all = 2 * lower + (count % 2 == 1 ? 2 : 1);
  std::size_t below = 0;
  double beyond = chances[0] / all;  // the chance of no more than `below`
  while (2 * (below + 1) < count && 1 - 2 * (beyond + chances[below + 1] / all) >= confidence)
    beyond += chances[++below] / all;
  const double median =
      count % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
  return {median, values[below], values[count - 1 - below], 1 - 2 * beyond};
}

}  // namespace flatray
