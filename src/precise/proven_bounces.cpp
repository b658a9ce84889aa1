#include "precise/proven_bounces.h"

#include "geom/decide.h"
#include "precise/module.h"

namespace flatray {

Proven proven_bounces(const Surfaces& walls, const Orbit& orbit,
                      std::span<const Material> materials) {
  const bool is_exact = orbit.end == OrbitEnd::escape || orbit.end == OrbitEnd::limit ||
                        orbit.end_point == orbit.start;  // no place was rounded
  if (orbit.bounces.empty() && orbit.crossings.empty() && is_exact) return {0, true};
  const PeriodicWalls periodic(walls, materials);
  Proof proof = prove<Bounded>(walls, periodic, orbit, kBounded);
  constexpr int kFirstBits = 256, kLastBits = 2048;
  const CertifiedModule* module = proof.ended ? nullptr : certified_module().table;
  for (int bits = kFirstBits; module != nullptr && !proof.ended && bits <= kLastBits; bits *= 2)
    proof = module->prove(walls, periodic, orbit, bits);
  // The first hit was decided without rounding.
  if (!periodic.any() && !orbit.bounces.empty())
    proof.proven.bounces = std::max<std::uint64_t>(proof.proven.bounces, 1);
  return proof.proven;
}

}  // namespace flatray
