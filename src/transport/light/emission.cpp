#include "transport/light/emission.h"

#include "base/philox.h"
#include "transport/light/net.h"
#include "transport/reflection.h"

namespace flatray {

Emission::Emission(std::span<const LampState> lamps, std::uint32_t block_rays, LightSampler sampler,
                   std::uint64_t seed, unsigned frame, double headroom)
    : lamps_(lamps), sampler_(sampler), seed_(seed), frame_(frame) {
  double brightest = 0, power = 0;  // parts of the brightest: nothing under- or overflows
  for (const LampState& lamp : lamps) brightest = std::max(brightest, lamp.power);
  const auto part = [&](std::size_t i) { return lamps[i].power / brightest; };
  for (std::size_t i = 0; i < lamps.size(); ++i) power += part(i);
  for (std::size_t i = 0; i < lamps.size(); ++i) {
    const double share = part(i) / power * block_rays + 0.5;
    first_.push_back(first_.back() + std::max(static_cast<std::uint32_t>(share), 1U));
  }
  const auto rays = [&](std::size_t i) { return first_[i + 1] - first_[i]; };
  double most = 0;
  for (std::size_t i = 0; i < lamps.size(); ++i) most = std::max(most, part(i) / rays(i));
  ray_power_ = headroom * most * brightest;
  for (std::size_t i = 0; i < lamps.size(); ++i) {
    LightWeight weight;
    for (std::size_t c = 0; c < weight.size(); ++c)
      weight[c] = static_cast<float>(part(i) / rays(i) / most / headroom * lamps[i].colour[c]);
    weights_.push_back(weight);
    for (unsigned k = 0; k < kMostLampNumbers; ++k)
      scrambles_.push_back(static_cast<std::uint32_t>(
          random_bits(seed, Stream::lamp, frame, std::uint64_t{lamps[i].lamp}, k)));
  }
}

LightRay Emission::ray(std::uint64_t block, std::uint32_t number) const {
  const std::uint32_t lamp = lamp_of(number);
  const std::uint32_t rays = first_[lamp + 1] - first_[lamp];
  const std::uint64_t sequence = block * rays + (number - first_[lamp]);
  const LampState& state = lamps_[lamp];
  std::array<double, kMostLampNumbers> u{};
  for (unsigned k = 0; k < state.numbers; ++k) u[k] = this->number(lamp, sequence, k);
  const Emitted local = state.emitter->emit(u.data());
  const Pose turn{{0, 0}, state.pose.cos, state.pose.sin};
  return {{state.pose(local.at), unit(turn.turned(local.direction))},
          {},
          weights_[lamp],
          number,
          static_cast<float>(state.nm)};
}

std::uint32_t Emission::lamp_of(std::uint32_t number) const {
  const auto after = std::ranges::upper_bound(first_, number);
  return static_cast<std::uint32_t>(after - first_.begin()) - 1;
}

Spectrum::Part Emission::part(std::uint32_t number, double u) const {
  if (const Spectrum* spectrum = lamps_[lamp_of(number)].spectrum) return spectrum->part(u);
  const double nm = kFirstWavelength + u * (kLastWavelength - kFirstWavelength);
  return {nm, part_of_wavelength(static_cast<double>(static_cast<float>(nm)))};
}

double Emission::number(std::uint32_t lamp, std::uint64_t sequence, unsigned dimension) const {
  const auto high = static_cast<std::uint32_t>(sequence >> 32);
  if (sampler_ == LightSampler::sorted) {
    const std::uint32_t scramble = scrambles_[lamp * kMostLampNumbers + dimension];
    constexpr std::uint32_t kGolden = 0x9e3779b9;  // each 2^32 rays have a net of their own
    return net_number(static_cast<std::uint32_t>(sequence), dimension, scramble ^ (kGolden * high));
  }
  const std::uint64_t lamp_seed = seed_ ^ (std::uint64_t{lamps_[lamp].lamp} << 40);
  return unit_double(random_bits(lamp_seed, Stream::lamp, frame_, sequence,
                                 kMostLampNumbers + dimension + (high << 8)));
}

}  // namespace flatray
