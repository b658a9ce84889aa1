#include "scene/material.h"

namespace flatray::isotropic_material {
namespace {

Result<std::unique_ptr<const Scatterer>> build(Args& args) {
  const Reflectance light = read_reflectance(args);
  return mixture({.isotropic = light.part, .tint = light.tint});
}

}  // namespace

extern const MaterialType entry = {"isotropic", "scatters alike into all directions, on both sides",
                                   kReflectanceKeys, &build};

}  // namespace flatray::isotropic_material
