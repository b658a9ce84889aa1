#pragma once
#include <span>
#include <vector>

#include "oracle/catalogue.h"
#include "trace/tracer.h"

namespace flatray {

/// How a tracer does on one stiff case.
struct CatalogueTally {
  std::uint64_t queries = 0;  ///< rays, and orbits
  std::uint64_t wrong = 0;  ///< of wall, or of whether there is one; orbits that meet other walls,
                            ///< end otherwise, or have another number of bounces
  std::uint64_t leaks = 0;  ///< orbits that come out of where they are
  double worst_ulps = 0;    ///< of t, where the wall is right
};

/// Needs   tracers that are not missing.
/// Gives   a tally for each.
/// Source  walls by oracle/nearest and oracle/long_orbit, t by the catalogue.
std::vector<CatalogueTally> check_case(const oracle::StiffCase& stiff,
                                       std::span<const Tracer* const> tracers);

}  // namespace flatray
