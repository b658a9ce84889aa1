#include "scene/material.h"

namespace flatray::materials {
namespace {

class Pass : public Scatterer {
 public:
  explicit Pass(const Reflectance& light) : light_(light) {}
  Departure scatter(const Arrival&, double u) const override {
    if (u >= light_.part) return {};
    return {Departure::Way::through, {1, 0}, light_.tint};
  }

 private:
  Reflectance light_;
};

constexpr KeyInfo kKeys[] = {{"transmittance", "number", "1"},
                             {"colour", "\"#rrggbb\"", "\"#ffffff\""}};

Result<std::unique_ptr<const Scatterer>> build(Args& args) {
  return std::make_unique<Pass>(read_reflectance(args, "transmittance"));
}

}  // namespace

extern const MaterialType pass = {"pass", "lets light through, as a filter does", kKeys, &build};

}  // namespace flatray::materials
