// What the program has of certified orbits without MPFR: it asks the module.
#include "base/module_file.h"
#include "precise/module.h"

namespace flatray {
namespace {

FoundModule find_module() {
  const LoadedEntry loaded = load_module(kCertifiedModule, kCertifiedEntry);
  if (loaded.entry == nullptr) return {nullptr, loaded.problem};
  const CertifiedModule* module = reinterpret_cast<CertifiedEntry>(loaded.entry)();
  if (module == nullptr || module->layout != kCertifiedLayout)
    return {nullptr, "its module belongs to another build of flatray"};
  return {module, ""};
}

}  // namespace

const FoundModule& certified_module() {
  static const FoundModule found = find_module();
  return found;
}

Result<void> can_certify() {
  const FoundModule& found = certified_module();
  if (found.module != nullptr) return {};
  return fail(named_place("certified orbits"), found.problem,
              "tools/setup installs MPFR, of which it is built; then build again",
              Trouble::unavailable);
}

Result<CertifiedOrbit> certified_orbit(const Surfaces& walls, const Ray& start,
                                       std::uint64_t bounces, const CertifiedRules& rules) {
  if (auto able = can_certify(); !able) return fail(std::move(able));
  return certified_module().module->certify(walls, start, bounces, rules);
}

std::uint64_t horizon(const Surfaces& walls, const CertifiedOrbit& exact,
                      std::span<const Bounce> plain) {
  const double far = kHorizonShare * bounds_of(walls).size().maxCoeff();
  const auto near = [&](const CertifiedOrbit::Bounce& there, const Bounce& here) {
    return there.surface == here.surface && (there.point - here.point).stableNorm() < far;
  };
  const auto parted =
      std::mismatch(exact.bounces.begin(), exact.bounces.end(), plain.begin(), plain.end(), near);
  return static_cast<std::uint64_t>(parted.first - exact.bounces.begin());
}

}  // namespace flatray
