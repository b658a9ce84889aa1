#pragma once
#include <optional>

#include "base/result.h"
#include "transport/orbit.h"

namespace flatray {

/// An orbit of which every bounce is proven.
struct CertifiedOrbit {
  struct Bounce {
    std::uint32_t surface;
    Vec2 point;  ///< the nearest doubles to the exact point
  };
  std::vector<Bounce> bounces;
  OrbitEnd end = OrbitEnd::limit;
  bool decided = true;  ///< false: proven so far, and `bits` were not enough for what comes next
  Vec2 out{0, 0};       ///< unit direction of an escape, nearest doubles
  Vec2 corner{0, 0};    ///< where it stops in a corner, nearest doubles
  std::vector<std::uint32_t> corner_walls;
  unsigned bits = 0;  ///< of working precision that were enough
};

inline constexpr unsigned kMostBits = 65536;

/// Error   Trouble::unavailable in a build without MPFR.
Result<void> can_certify();

/// Follows the exact orbit of `start` between mirrors: the working precision is doubled, from 128
/// bits on, until every bounce is told and every point is rounded.
///
/// Needs   a direction that is not zero.
/// Gives   ends as trace_orbit has them; a corner where the arithmetic meets it exactly, as between
///         straight walls of whole coordinates; else it stays undecided, as does a tangent of a
///         circle met exactly. A coordinate within 2^-256 of the largest one of the walls to the
///         middle between two doubles is the even one, and one as near to 0 is 0: exact ties, which
///         no number of bits would tell.
/// Error   that of can_certify.
/// Cost    bits grow by some 0.5 a bounce between straight walls, and by what discs part rays: 512
///         for 200 bounces of a Sinai room, 20 ms. Every precision begins again at the start, so
///         work is counted, as bounces times (walls + 1) times bits: after `most_work`, 2^32 unless
///         said and more in proportion for more than kMostBits, the orbit stays undecided, as if bits had run out. That is a minute
///         or two, and some ten with 65536 bits.
Result<CertifiedOrbit> certified_orbit(const Surfaces& walls, const Ray& start,
                                       std::uint64_t bounces, unsigned most_bits = kMostBits,
                                       std::optional<std::uint64_t> most_work = std::nullopt);

}  // namespace flatray
