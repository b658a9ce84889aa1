#include "scene/material.h"

namespace flatray::pass_material {
namespace {

constexpr KeyInfo kKeys[] = {{"transmittance", "number", "1"},
                             {"colour", "\"#rrggbb\"", "\"#ffffff\""}};

Result<std::unique_ptr<const Scatterer>> build(Args& args) {
  const Reflectance light = read_reflectance(args, "transmittance");
  return mixture({.pass = light.part, .tint = light.tint});
}

}  // namespace

extern const MaterialType entry = {"pass", "lets light through, as a filter does", kKeys, &build};

}  // namespace flatray::pass_material
