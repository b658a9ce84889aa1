#include "scene/material.h"

namespace flatray::diffuse_material {
namespace {

Result<std::unique_ptr<const Scatterer>> build(Args& args) {
  const Reflectance light = read_reflectance(args);
  return mixture({.diffuse = light.part, .tint = light.tint});
}

}  // namespace

extern const MaterialType entry = {"diffuse", "matt: looks alike from all sides", kReflectanceKeys,
                                   &build};

}  // namespace flatray::diffuse_material
