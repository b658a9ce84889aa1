#pragma once
#include <vector>

#include "oracle/moving_pairs.h"
#include "oracle/turning_contact.h"

namespace flatray::oracle {

/// Two turning bodies whose rings it keeps. Sizes about 1, time from 0 to 1.
struct TurningPair {
  std::vector<Vec2> ring_a, ring_b;
  TurningCore shaped_a, shaped_b;  ///< all but their rings

  TurningCore a() const { return with(shaped_a, ring_a); }
  TurningCore b() const { return with(shaped_b, ring_b); }

 private:
  static TurningCore with(TurningCore core, const std::vector<Vec2>& ring) {
    core.ring = ring;
    return core;
  }
};

using TurningFamily = FamilyOf<TurningPair>;
std::span<const TurningFamily> turning_families();

}  // namespace flatray::oracle
