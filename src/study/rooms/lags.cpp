#include "study/rooms/lags.h"

#include <algorithm>

namespace flatray {

LagTimes LagTimes::of(double mean_flight, std::uint64_t bounces) {
  constexpr double kMostSamples = 512, kInFlight = 4;
  const double end = mean_flight * static_cast<double>(bounces) * 2 / 3;
  const double step = std::max(mean_flight / kInFlight, end / kMostSamples);
  const auto samples = static_cast<std::size_t>(end / step) / 8 * 8;
  return {step, samples + 1, samples / 4 + 1};
}

Lags Lags::of(std::span<const Vec2> places, std::span<const Vec2> ways, std::size_t lags) {
  Lags all;
  for (std::size_t lag = 0; lag < lags; ++lag) {
    const std::size_t begins = places.size() - lag;
    double x = 0, y = 0, velocity = 0, kubo = 0;
    for (std::size_t i = 0; i < begins; ++i) {
      const Vec2 moved = places[i + lag] - places[i];
      x += moved.x() * moved.x();
      y += moved.y() * moved.y();
      velocity += ways[i].dot(ways[i + lag]);
      // Forward from the beginning and back from the end, which is the same by symmetry.
      kubo += 0.5 * (ways[i] + ways[i + lag]).dot(moved);
    }
    const auto number = static_cast<double>(begins);
    all.x.push_back(x / number);
    all.y.push_back(y / number);
    all.velocity.push_back(velocity / number);
    all.kubo.push_back(kubo / number);
  }
  return all;
}

}  // namespace flatray
