#pragma once
#include <span>
#include <vector>

#include "study/rooms/followed.h"
#include "study/rooms/scene_orbits.h"
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
Result<BoundaryOrbits> boundary_orbits(const ExperimentContext& context, const Room& room,
                                       std::uint64_t random_orbits);

/// Shows each of some orbits to a watch of its own, which has see(BoundaryPoint), and numbers() of
/// what it found.
template <class Watch>
class WatchedBounces : public OrbitSink {
 public:
  WatchedBounces(const Room& room, std::size_t orbits, const Watch& watch)
      : room_(room), watches_(orbits, watch) {}
  void bounce(std::size_t number, const Bounce& bounce) override {
    watches_[number].see(
        {room_.place_of(bounce) / room_.perimeter(), sine_of(bounce.out, bounce.normal)});
  }
  /// Of each watch how many, then these.
  Numbers numbers() const {
    Numbers all;
    for (const Watch& watch : watches_) {
      const Numbers found = watch.numbers();
      all.push_back(static_cast<double>(found.size()));
      all.insert(all.end(), found.begin(), found.end());
    }
    return all;
  }

 private:
  const Room& room_;
  std::vector<Watch> watches_;
};

/// Follows them in blocks (study/statistics/blocks.h), each with a watch that begins as `watch` is.
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
        WatchedBounces<Watch> bounces(room, some.size(), watch);
        follow_starts(context, room, some, orbits.bounces, bounces);
        return bounces.numbers();
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
