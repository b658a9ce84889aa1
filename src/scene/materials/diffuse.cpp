#include "scene/material.h"

namespace flatray::materials {
namespace {

class Diffuse : public Scatterer {
 public:
  explicit Diffuse(const Reflectance& light) : light_(light) {}
  Departure scatter(const Arrival& arrival, double u) const override {
    if (u >= light_.part) return {};
    return {Departure::Way::scattered, lambert_direction(arrival.normal, u / light_.part),
            light_.tint, true};
  }

 private:
  Reflectance light_;
};

Result<std::unique_ptr<const Scatterer>> build(Args& args) {
  return std::make_unique<Diffuse>(read_reflectance(args));
}

}  // namespace

extern const MaterialType diffuse = {"diffuse", "matt: looks alike from all sides",
                                     kReflectanceKeys, &build};

}  // namespace flatray::materials
