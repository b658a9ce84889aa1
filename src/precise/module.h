#pragma once
#include "base/module_file.h"
#include "precise/certified_orbit.h"
#include "precise/proof.h"

namespace flatray {

/// What the program and its module flatray_certified.so say to each other: orbits in as many bits as
/// they need. The module alone is linked with MPFR; it holds its own copy of what it shares with the
/// program, and belongs to the build that made it.
struct CertifiedModule {
  std::uint64_t layout;  ///< kCertifiedLayout of the build that made it
  CertifiedOrbit (*certify)(const Surfaces& walls, const Ray& start, std::uint64_t bounces,
                            const CertifiedRules& rules);
  /// Bounces told by balls of so many bits.
  Proof (*prove)(const Surfaces& walls, const PeriodicWalls& periodic, const Orbit& orbit,
                 int bits);
};

/// Tells builds apart whose structs differ.
inline constexpr std::uint64_t kCertifiedLayout =
    ((sizeof(Surfaces) * 1000 + sizeof(CertifiedOrbit)) * 1000 + sizeof(Orbit)) * 1000 +
    sizeof(PeriodicWalls);

inline constexpr char kCertifiedEntry[] = "flatray_certified_module";

/// certified_orbit, inside the module.
CertifiedOrbit certify(const Surfaces& walls, const Ray& start, std::uint64_t bounces,
                       const CertifiedRules& rules);

/// The module, loaded when first asked for.
const LoadedTable<CertifiedModule>& certified_module();

}  // namespace flatray
