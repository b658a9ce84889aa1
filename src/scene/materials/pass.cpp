#include "scene/material.h"

namespace flatray::materials {
namespace {

constexpr KeyInfo kKeys[] = {{"transmittance", "number", "1"},
                             {"colour", "\"#rrggbb\"", "\"#ffffff\""}};

Result<std::unique_ptr<const Scatterer>> build(Args& args) {
  const Reflectance light = read_reflectance(args, "transmittance");
  return mixture({.pass = light.part, .tint = light.tint});
}

}  // namespace

extern const MaterialType pass = {"pass", "lets light through, as a filter does", kKeys, &build};

}  // namespace flatray::materials
