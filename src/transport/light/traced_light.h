#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "image/film_rounds.h"
#include "image/light_film.h"

namespace flatray {

/// What became of the light, in units of 2^-20 of a channel of a ray: what was emitted is the sum of
/// the others, exactly.
struct LightCounts {
  std::uint64_t rays = 0, legs = 0;  ///< legs: straight parts of paths
  std::int64_t emitted = 0, absorbed = 0, escaped = 0;
  std::int64_t at_corners = 0;  ///< met the end of a wall, or a point where walls meet
  std::int64_t cut_off = 0;     ///< after the last bounce allowed
  std::int64_t gambled = 0;     ///< lost, less won, by faint rays of which some go on brighter

  LightCounts& operator+=(const LightCounts& more);
};

/// On the film, of a leg that fades: 8.5 / (1/16) pieces, one that is begun, one for rounding and the first twice,
/// for each channel, and the rest. Others are one line.
inline constexpr std::uint64_t kMostLinesOfLeg = 3 * 139 + 1;

/// The light of a frame: independent pictures of it, one for each scramble, and all of them have seen
/// the same rounds of rays.
struct TracedLight {
  std::vector<LightFilm> films{};  ///< of each scramble; none before the first round
  double round_unit = 0;  ///< fluence (power per world length) of one unit of a film of one round
  LightCounts counts{};
  FilmRounds rounds{};
  bool whole = true;  ///< not stopped: else there is part of a round in it

  /// Of all scrambles together, three channels a pixel, and the fluence of one unit of them.
  std::vector<std::int64_t> sums() const;
  double unit() const { return film_unit() / static_cast<double>(films.size()); }
  /// Fluence of one unit of the film of a scramble.
  double film_unit() const {
    return round_unit / static_cast<double>(std::max<std::uint64_t>(rounds.count(), 1));
  }
  std::uint64_t lines() const;
};

/// Rays in rounds of so many, of all scrambles together and fixed by their numbers: more rays are
/// more rounds.
inline constexpr std::uint64_t kLightRound = std::uint64_t{1} << 18;
/// Rounds of `rays` asked for: one of fewer rays, else whole rounds.
std::uint64_t rounds_of(std::uint64_t rays);
/// What is traced of them, but for rounding to the shares of the lamps and scrambles.
std::uint64_t rays_traced(std::uint64_t rays);

/// The number of the round to be traced next, below FilmRounds::kMost, after what has been traced;
/// nothing ends it.
using NextRound = std::function<std::optional<std::uint64_t>(const TracedLight& so_far)>;

}  // namespace flatray
