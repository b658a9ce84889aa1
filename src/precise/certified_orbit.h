#pragma once
#include <optional>

#include "base/result.h"
#include "transport/orbit.h"

namespace flatray {

/// An orbit of which every bounce is proven; its end is told in nearest doubles, `out` of an escape alone.
struct CertifiedOrbit : OrbitStop {
  /// Of exact numbers the nearest doubles.
  struct Bounce {
    std::uint32_t surface;
    Vec2 point;
    double t;      ///< since the last one, in the start's directions, or the largest double
    Vec2 normal;   ///< unit, towards the side the ray came from
    Vec2 in, out;  ///< unit directions before and after it
    CellIndex cell{};
  };
  std::vector<Bounce> bounces;
  bool decided = true;  ///< false: proven so far, and `bits` were not enough for what comes next
  std::vector<Crossing> crossings;  ///< of periodic walls
  unsigned bits = 0;      ///< of the longest number: of working precision, or of one without error
  bool rational = false;  ///< what balls left open is told by numbers without error
};

inline constexpr unsigned kMostBits = 65536;

/// What bounds a certified orbit.
struct CertifiedRules {
  std::span<const Material>
      materials{};  ///< by surface, as trace_orbit has them; none: all mirrors
  unsigned most_bits = kMostBits;
  /// 2^32 where not said, and more in proportion for more than kMostBits.
  std::optional<std::uint64_t> most_work{};
};

/// Error   Trouble::unavailable where the module flatray_certified.so is not there.
Result<void> can_certify();

/// Follows the exact orbit of `start`: the working precision is doubled, from 128 bits on, until
/// every bounce is told and every point is rounded. Where more bits got no further, numbers without
/// error tell what they cannot, as long as they are rational or a + b sqrt(q) with one root: a corner
/// or a tangent met exactly, a coordinate that is 0 or the middle between two doubles.
///
/// Needs   a direction that is not zero.
/// Gives   ends as trace_orbit has them, in corners by the rule `stop`. Nothing is taken to be equal
///         because it is near: what neither arithmetic proves is left undecided. Walls on one line or
///         curve are known to meet a ray in one point.
/// Error   that of can_certify.
/// Cost    bits grow by the logarithm of the number of bounces between straight walls and in a
///         circle, and by what discs part rays: 512 for 200 bounces of a Sinai room, 20 ms. Numbers
///         without error grow by up to 106 bits a bounce, and by none in a room whose walls lie along
///         the axes; those longer than 16 times the working precision become balls. Every precision
///         begins again at the start, so work is counted, as bounces times (walls + 1) times bits:
///         after `most_work` the orbit stays undecided, as if bits had run out. That is a minute or
///         two, and some ten with 65536 bits.
Result<CertifiedOrbit> certified_orbit(const Surfaces& walls, const Ray& start,
                                       std::uint64_t bounces, const CertifiedRules& rules = {});

/// Of the largest extent of a room: as far as an orbit of doubles may be off before it is noise.
inline constexpr double kHorizonShare = 0.01;

/// Whether two bounces are on one wall, in one cell of periodic walls.
template <class One>
bool is_same_wall(const One& one, const CertifiedOrbit::Bounce& other) {
  return one.surface == other.surface && one.cell == other.cell;
}

/// Bounces from the first on that the orbit of the same start in doubles has on the same walls, in the
/// same cells of periodic walls, near the same points. Where they are fewer than those of `exact`, what
/// follows is noise; of more bounces than these nothing is said.
std::uint64_t horizon(const Surfaces& walls, const CertifiedOrbit& exact,
                      std::span<const Bounce> plain);

}  // namespace flatray
