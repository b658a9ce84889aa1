#pragma once
#include "oracle/catalogue.h"
#include "oracle/long_orbit.h"
#include "study/stability/catalogue_check.h"

namespace flatray {

/// What check_case() does of rays, put into `tally`, with its `ulps` in any order. `truth` is of
/// each start.
void check_orbits(const oracle::StiffOrbits& orbits, const std::vector<oracle::LongOrbit>& truth,
                  const Tracer& tracer, CatalogueTally& tally);

void check_certified_orbits(const oracle::StiffOrbits& orbits,
                            const std::vector<oracle::LongOrbit>& truth, CatalogueTally& tally);

/// What a batch comes to, timed, and counted what is not left to lanes.
std::vector<NearestHit> measured_hits(const Accelerator& walls, const RayBatch& rays,
                                      std::size_t objects, CatalogueTally& tally);

}  // namespace flatray
