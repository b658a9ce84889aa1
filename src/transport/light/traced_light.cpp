#include "transport/light/traced_light.h"

#include <algorithm>

namespace flatray {

LightCounts& LightCounts::operator+=(const LightCounts& more) {
  rays += more.rays, legs += more.legs;
  emitted += more.emitted, absorbed += more.absorbed, escaped += more.escaped;
  at_corners += more.at_corners, cut_off += more.cut_off, gambled += more.gambled;
  return *this;
}

std::vector<std::int64_t> TracedLight::sums() const {
  std::vector<std::int64_t> all = films.front().sums();
  for (std::size_t i = 1; i < films.size(); ++i) {
    const std::vector<std::int64_t> more = films[i].sums();
    std::transform(all.begin(), all.end(), more.begin(), all.begin(), std::plus<>());
  }
  return in_three_channels(std::move(all), films.front().channels());
}

std::uint64_t TracedLight::lines() const {
  std::uint64_t lines = 0;
  for (const LightFilm& film : films) lines += film.lines();
  return lines;
}

std::uint64_t rounds_of(std::uint64_t rays) { return (rays + kLightRound - 1) / kLightRound; }

std::uint64_t rays_traced(std::uint64_t rays) {
  return rays <= kLightRound ? rays : rounds_of(rays) * kLightRound;
}

}  // namespace flatray
