// What the program has of certified orbits without MPFR: it asks the module.
#include "precise/module.h"

namespace flatray {

const LoadedTable<CertifiedModule>& certified_module() {
  static const LoadedTable<CertifiedModule> found =
      load_table(kCertifiedModule, kCertifiedEntry, &CertifiedModule::layout, kCertifiedLayout);
  return found;
}

Result<void> can_certify() {
  const LoadedTable<CertifiedModule>& found = certified_module();
  if (found.table != nullptr) return {};
  return fail(named_place("certified orbits"), found.problem,
              "tools/setup installs MPFR, of which it is built; then build again",
              Trouble::unavailable);
}

Result<CertifiedOrbit> certified_orbit(const Surfaces& walls, const Ray& start,
                                       std::uint64_t bounces, const CertifiedRules& rules) {
  if (auto able = can_certify(); !able) return fail(std::move(able));
  return certified_module().table->certify(walls, start, bounces, rules);
}

std::uint64_t horizon(const Surfaces& walls, const CertifiedOrbit& exact,
                      std::span<const Bounce> plain) {
  const double far = kHorizonShare * bounds_of(walls).size().maxCoeff();
  const auto near = [&](const CertifiedOrbit::Bounce& there, const Bounce& here) {
    return is_same_wall(here, there) && (there.point - here.point).stableNorm() < far;
  };
  const auto parted =
      std::mismatch(exact.bounces.begin(), exact.bounces.end(), plain.begin(), plain.end(), near);
  return static_cast<std::uint64_t>(parted.first - exact.bounces.begin());
}

}  // namespace flatray
