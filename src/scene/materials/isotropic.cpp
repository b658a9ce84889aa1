#include "scene/material.h"

namespace flatray::materials {
namespace {

class Isotropic : public Scatterer {
 public:
  explicit Isotropic(const Reflectance& light) : light_(light) {}
  Departure scatter(const Arrival&, double u) const override {
    if (u >= light_.part) return {};
    return {Departure::Way::scattered, any_direction(u / light_.part), light_.tint};
  }

 private:
  Reflectance light_;
};

Result<std::unique_ptr<const Scatterer>> build(Args& args) {
  return std::make_unique<Isotropic>(read_reflectance(args));
}

}  // namespace

extern const MaterialType isotropic = {
    "isotropic", "scatters alike into all directions, on both sides", kReflectanceKeys, &build};

}  // namespace flatray::materials
