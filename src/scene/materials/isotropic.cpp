#include "scene/material.h"

namespace flatray::isotropic_material {

extern const MaterialType entry = {"isotropic", "scatters alike into all directions, on both sides",
                                   kReflectanceKeys, &build_one_way<&LightShares::isotropic>};

}  // namespace flatray::isotropic_material
