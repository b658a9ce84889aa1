// The entry of the module flatray_certified.so.
#include "precise/module.h"

#include "precise/ball.h"

namespace flatray {
namespace {

Proof prove_in_balls(const Surfaces& walls, const PeriodicWalls& periodic, const Orbit& orbit,
                     int bits) {
  return prove<Ball>(walls, periodic, orbit, [bits](double x) { return Ball(x, bits); });
}

constexpr CertifiedModule kModule = {kCertifiedLayout, &certify, &prove_in_balls};

}  // namespace
}  // namespace flatray

extern "C" __attribute__((visibility("default"))) const flatray::CertifiedModule*
flatray_certified_module() {
  return &flatray::kModule;
}
