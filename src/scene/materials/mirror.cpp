#include "scene/material.h"

namespace flatray::mirror_material {

extern const MaterialType entry = {"mirror", "reflects, and may swallow a part or tint it",
                                   kReflectanceKeys,
                                   &build_one_way<&LightShares::mirror, Material::mirror>};

}  // namespace flatray::mirror_material
