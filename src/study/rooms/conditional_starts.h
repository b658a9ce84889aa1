#pragma once
#include "study/rooms/pixel_map.h"
#include "study/rooms/splitting.h"
#include "study/rooms/survival.h"

namespace flatray {

/// Starts spread as what is left of an open room after long: by the conditionally invariant measure
/// of its bounces, under which orbits leave exponentially from the first bounce on. They are
/// kShifts populations that know nothing of each other, each kept at its size by clones
/// (study/rooms/splitting.h) until the beginning is forgotten.
///
/// Error   clones are turned by up to 2^-7 radians, which blurs the measure as much; within a group
///         starts are not independent, so that errors come from what groups differ by.
/// Source  Burdzy, Holyst, Ingerman and March 1996; Del Moral, Feynman-Kac Formulae, 2004, chapter
///         4.
class ConditionalStarts {
 public:
  /// `count` of them in all.
  ///
  /// Cost    as many orbits through some three times `memory()` bounces.
  /// Error   orbits leave like a power, so that nothing of this kind is come to; too few to tell;
  ///         too few in a group.
  static Result<ConditionalStarts> draw(const ExperimentContext& context, const Room& room,
                                        std::uint64_t bounces);
  /// That of a number below the count, of group number % kShifts.
  const OrbitStart& operator[](std::uint64_t number) const {
    return groups_[number % kShifts][number / kShifts];
  }
  /// Bounces after which starts by the measure that reflection keeps have forgotten how they began.
  double memory() const { return memory_; }

 private:
  std::vector<std::vector<OrbitStart>> groups_;
  double memory_ = 0;
};

/// When orbits leave, of those that started in the free.
std::vector<LeavingOrbit> departures_of(std::span<const PixelOutcome> orbits);

}  // namespace flatray
