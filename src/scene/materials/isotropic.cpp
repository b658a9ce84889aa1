#include "scene/material.h"

namespace flatray::materials {
namespace {

Result<std::unique_ptr<const Scatterer>> build(Args& args) {
  const Reflectance light = read_reflectance(args);
  return mixture({.isotropic = light.part, .tint = light.tint});
}

}  // namespace

extern const MaterialType isotropic = {
    "isotropic", "scatters alike into all directions, on both sides", kReflectanceKeys, &build};

}  // namespace flatray::materials
