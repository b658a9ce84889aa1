#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "trace/rays.h"

namespace flatray {

/// Of red, green and blue, in units of the brightest ray of all lamps: at most 1.
using LightWeight = std::array<float, 3>;

inline float largest(const LightWeight& weight) {
  return std::max({weight[0], weight[1], weight[2]});
}

/// In the whole numbers in which energy is counted: LightCounts.
inline std::int64_t energy(const LightWeight& weight) {
  constexpr double kUnits = 0x1p20;
  std::int64_t sum = 0;
  for (const float channel : weight) sum += std::llrint(static_cast<double>(channel) * kUnits);
  return sum;
}

/// Bodies with an index of refraction that light is in. A body of a higher number is the inner one.
class Media {
 public:
  /// Of more than kMost the outermost is forgotten.
  void enter(std::uint32_t body) {
    if (count_ == kMost) {
      forgets_ = true;
      if (body < bodies_[0]) return;
      std::copy(bodies_.begin() + 1, bodies_.end(), bodies_.begin()), --count_;
    }
    std::uint32_t at = count_++;
    for (; at > 0 && bodies_[at - 1] > body; --at) bodies_[at] = bodies_[at - 1];
    bodies_[at] = body;
  }
  void leave(std::uint32_t body) {
    auto* const end = bodies_.begin() + count_;
    count_ = static_cast<std::uint16_t>(std::remove(bodies_.begin(), end, body) - bodies_.begin());
  }
  /// The innermost but for `body`; kNone where there is none.
  std::uint32_t around(std::uint32_t body) const {
    for (std::uint32_t i = count_; i-- > 0;)
      if (bodies_[i] != body) return bodies_[i];
    return kNone;
  }
  /// Whether there may be more than it knows: Bodies::at tells them anew.
  bool forgets() const { return forgets_; }
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

 private:
  static constexpr std::uint32_t kMost = 8;
  std::array<std::uint32_t, kMost> bodies_{};  // ascending
  std::uint16_t count_ = 0;
  bool forgets_ = false;
};

/// Light under way.
struct LightRay {
  Ray ray;  ///< direction of length 1
  DepartedSurface departed;
  LightWeight weight{0, 0, 0};
  std::uint32_t number = 0;  ///< in its block
  float nm = 0;              ///< wavelength; 0: all of them together
  Media media{};
};

}  // namespace flatray
