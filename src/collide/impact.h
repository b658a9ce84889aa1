#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geom/vec.h"

namespace flatray {

struct ImpactBody {
  Vec2 velocity;
  double mass;  ///< infinite: pushed by nothing
};

/// Two bodies that touch, and how: they part by as much as they came, or slide on along each other.
struct ImpactContact {
  std::uint32_t a, b;
  Vec2 normal;  ///< out of a; its length does not count
  bool slides;
};

struct Impact {
  std::vector<Vec2> velocities;  ///< of all bodies, after it
  std::vector<bool> rests;       ///< of all contacts: those that slide and do not part
  bool refused = false;          ///< it would take more than kMostGuess: there is nothing else
};

/// What slides leaves at this part of the largest speed about, where it cannot be at rest against the
/// other in doubles: more than rounding of a normal and of velocities, some 2^-50 of them.
inline constexpr double kSlideLeaves = 0x1p-40;

/// Words multiplied with words, and contacts, up to which velocities are exact.
inline constexpr double kMostWork = 1 << 14;
inline constexpr std::size_t kMostProven = 1 << 10;

/// What pushes along the normals, all at one instant, make of velocities: docs/adr/0020.
///
/// Gives   pushes p >= 0 so that w >= 0, and p or w is 0 of each contact: w is the speed of parting,
///         for those that bounce plus that before. Contacts that bounce and do not approach are left
///         out. The velocities do not depend on the order of bodies and contacts. nullopt where
///         there is no way out, as between walls that close in.
/// Error   velocities are the exact ones, rounded once, and no way out is proven, within the limits of
///         complementarity.h, to rounding beyond them; for a normal not along an axis, of what slides,
///         with kSlideLeaves.
/// Cost    that of solve_complementarity, twice where something must leave; what takes more than kMostGuess is
///         refused, as the cube of contacts would have to be waited for.
std::optional<Impact> solve_impact(std::span<const ImpactBody> bodies,
                                   std::span<const ImpactContact> contacts);

}  // namespace flatray
