#include "scene/material.h"

namespace flatray::diffuse_material {

extern const MaterialType entry = {"diffuse", "matt: looks alike from all sides", kReflectanceKeys,
                                   &build_one_way<&LightShares::diffuse>};

}  // namespace flatray::diffuse_material
