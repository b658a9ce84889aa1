#pragma once
#include <span>
#include <vector>

#include "anim/lamps.h"
#include "scene/scene.h"
#include "transport/light/light_ray.h"

namespace flatray {

/// Sends out the rays of a block. Each lamp has as many of them, the same in every block, as its
/// share of the power is, at least one.
class Emission {
 public:
  /// Needs   lamps, which outlive it.
  /// The brightest ray has a weight of 1 / `headroom`.
  Emission(std::span<const LampState> lamps, std::uint32_t block_rays, LightSampler sampler,
           std::uint64_t seed, unsigned frame, double headroom);

  /// Rays of a block: `block_rays` but for rounding, and one for each lamp too faint for any.
  std::uint32_t size() const { return first_.back(); }
  /// Power of the largest channel of a ray of weight 1, were there one block.
  double ray_power() const { return ray_power_; }
  /// Ray `number` of a block, in the world.
  LightRay ray(std::uint64_t block, std::uint32_t number) const;
  /// A wavelength for it by chance `u`, uniform in [0, 1), where it has none, and what is then left
  /// of its colours.
  Spectrum::Part part(std::uint32_t number, double u) const;

  /// The lamp of ray `number` of a block.
  std::uint32_t lamp_of(std::uint32_t number) const;

 private:
  double number(std::uint32_t lamp, std::uint64_t sequence, unsigned dimension) const;

  std::span<const LampState> lamps_;
  const LightSampler sampler_;
  const std::uint64_t seed_;
  const unsigned frame_;
  std::vector<std::uint32_t> first_{0};   // of each lamp, and the end
  std::vector<LightWeight> weights_;      // of each lamp's rays
  std::vector<std::uint32_t> scrambles_;  // of each lamp's dimensions
  double ray_power_ = 0;
};

}  // namespace flatray
