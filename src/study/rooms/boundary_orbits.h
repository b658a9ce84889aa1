#pragma once
#include <span>
#include <vector>

#include "study/rooms/followed.h"
#include "study/statistics/blocks.h"

namespace flatray {

/// Where on the walls an orbit bounces: how far along them, as a share of all walls, and the sine
/// of the angle at which it leaves, in the sense of the walls. Reflection keeps areas in it.
struct BoundaryPoint {
  double along, sine;
};

/// Orbits of the scene's rays, or drawn ones, that share the bounces of the context's count.
struct BoundaryOrbits {
  NamedOrbits orbits;
  std::uint64_t bounces;  ///< of each, unless it ends
};
inline Result<BoundaryOrbits> boundary_orbits(const ExperimentContext& context, const Room& room,
                                              std::uint64_t random_orbits) {
  FLATRAY_TRY(watched, orbits_to_watch(context, room, random_orbits));
  const std::uint64_t orbits = watched->starts.size();
  return BoundaryOrbits{std::move(*watched),
                        context.bounces.value_or((context.count + orbits - 1) / orbits)};
}

/// Follows them in blocks (study/statistics/blocks.h), each shown to a watch of its own, which begins
/// as `watch` is and has see(BoundaryPoint), and numbers() of what it found.
/// Gives   the audit of fast orbits; what each watch found to `take`, in the order of the orbits.
template <class Watch, class Take>
Result<std::vector<Measure>> watch_bounces(const ExperimentContext& context, const Room& room,
                                           const BoundaryOrbits& orbits, const Watch& watch,
                                           const Take& take) {
  constexpr std::uint64_t kOrbitsABlock = 4;
  const std::span starts(orbits.orbits.starts);
  const Blocks blocks{starts.size(), kOrbitsABlock};
  std::size_t orbit = 0;
  auto ran = fold_blocks(
      context, blocks.count(),
      [&](std::size_t block) {
        const auto some =
            starts.subspan(blocks.begin(block), blocks.end(block) - blocks.begin(block));
        std::vector<Watch> watches(some.size(), watch);
        BounceSink sink([&](std::size_t number, const Bounce& bounce) {
          watches[number].see(
              {room.place_of(bounce) / room.perimeter(), sine_of(bounce.out, bounce.normal)});
        });
        follow_starts(context, room, some, orbits.bounces, sink);
        Numbers all;  // of each watch how many, then these
        for (const Watch& one : watches) {
          const Numbers found = one.numbers();
          all.push_back(static_cast<double>(found.size()));
          all.insert(all.end(), found.begin(), found.end());
        }
        return all;
      },
      [&](const Numbers& block) {
        for (std::span<const double> rest(block); !rest.empty();) {
          const auto size = static_cast<std::size_t>(rest.front());
          take(orbit++, rest.subspan(1, size));
          rest = rest.subspan(1 + size);
        }
      });
  if (!ran) return fail(std::move(ran));
  return audit(context, room, starts, orbits.bounces);
}

}  // namespace flatray
