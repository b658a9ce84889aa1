#include "scene/material.h"

namespace flatray::materials {
namespace {

class Mirror : public Scatterer {
 public:
  explicit Mirror(const Reflectance& light) : light_(light) {}
  Departure scatter(const Arrival&, double u) const override {
    if (u >= light_.part) return {};
    return {Departure::Way::mirrored, {1, 0}, light_.tint};
  }
  Material for_rays() const override { return Material::mirror; }

 private:
  Reflectance light_;
};

Result<std::unique_ptr<const Scatterer>> build(Args& args) {
  return std::make_unique<Mirror>(read_reflectance(args));
}

}  // namespace

extern const MaterialType mirror = {"mirror", "reflects, and may swallow a part or tint it",
                                    kReflectanceKeys, &build};

}  // namespace flatray::materials
