#pragma once
#include "study/periodic/closed_orbits.h"
#include "study/plots/plot.h"

namespace flatray {

/// The walls of a room, and the shortest of the orbits in it, of those alike by symmetry one each.
Plot plot_of_orbits(const MirrorRoom& room, const std::vector<const ClosedOrbit*>& orbits);
/// Eigenvalues by length, of unstable ones.
Plot plot_of_stability(const std::vector<const ClosedOrbit*>& orbits);

}  // namespace flatray
