#pragma once
#include <array>
#include <cstdint>

namespace flatray {

/// Philox4x32-10 of Salmon et al. 2011, "Parallel random numbers: as easy as 1, 2, 3": a bijection
/// of the counter under a key, so every draw has a name instead of a state.
std::array<std::uint32_t, 4> philox4x32(std::array<std::uint32_t, 4> counter,
                                        std::array<std::uint32_t, 2> key);

/// What a draw is for. The numbers are part of every picture ever rendered: append, never renumber.
enum class Stream : std::uint32_t {
  markov = 1,
  experiment = 2,
  test = 3,
  scatter = 4,
  value = 5,
  lamp = 6,          ///< how rays leave lamps
  bounce = 7,        ///< what becomes of light at a wall
  roulette = 8,      ///< which faint rays go on
  colour = 9,        ///< wavelengths of light that comes to what disperses
  gather = 10,       ///< paths from pixels to lamps
  scramble = 11,     ///< seeds of pictures of light that are compared with one another
  alternative = 12,  ///< which of its alternatives light meets of a wall
  split = 13,        ///< whether orbits are reflected or refracted by glass
  fading = 14,       ///< where light that fades on its way is cut
};

/// 64 uniform bits named by (seed, stream, frame, item, draw). `frame` and `item` keep 32 bits
/// each.
std::uint64_t random_bits(std::uint64_t seed, Stream stream, std::uint64_t frame,
                          std::uint64_t item, std::uint32_t draw = 0);

/// A double uniform on [0, 1): the upper 53 of the bits.
inline double unit_double(std::uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1p-53; }

}  // namespace flatray
