#pragma once
#include "oracle/moving_pairs.h"
#include "oracle/turning_contact.h"

namespace flatray::oracle {

/// Two turning bodies. Sizes about 1, time from 0 to 1.
struct TurningPair {
  TurningCore a, b;
};

using TurningFamily = FamilyOf<TurningPair>;
std::span<const TurningFamily> turning_families();

}  // namespace flatray::oracle
