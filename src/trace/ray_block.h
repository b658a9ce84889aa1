#pragma once
#include <algorithm>

#include "trace/kernels/lanes.h"
#include "trace/rays.h"

namespace flatray {

/// Some rays of a batch as kernels take them, in whole vectors of the widest tier.
class RayBlock {
 public:
  static std::size_t whole_vectors(std::size_t count) {
    constexpr auto kWide = static_cast<std::size_t>(lanes::kWidest);
    return (count + kWide - 1) / kWide * kWide;
  }

  /// The rays where they are, or, where they fill no whole vectors, a copy with the last one again.
  lanes::Rays take(const RayBatch& rays, std::size_t begin, std::size_t count) {
    const std::size_t whole = whole_vectors(count);
    if (whole != count) {
      padded_.resize(0);
      for (std::size_t i = 0; i < whole; ++i) padded_.add(rays.ray(begin + std::min(i, count - 1)));
    }
    const RayBatch& from = whole == count ? rays : padded_;
    const std::size_t first = whole == count ? begin : 0;
    return {&from.ox[first], &from.oy[first], &from.dx[first], &from.dy[first],
            static_cast<int>(whole)};
  }

 private:
  RayBatch padded_;
};

}  // namespace flatray
