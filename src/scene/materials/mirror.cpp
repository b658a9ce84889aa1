#include "scene/material.h"

namespace flatray::mirror_material {
namespace {

Result<std::unique_ptr<const Scatterer>> build(Args& args) {
  const Reflectance light = read_reflectance(args);
  return mixture({.mirror = light.part, .tint = light.tint}, Material::mirror);
}

}  // namespace

extern const MaterialType entry = {"mirror", "reflects, and may swallow a part or tint it",
                                   kReflectanceKeys, &build};

}  // namespace flatray::mirror_material
