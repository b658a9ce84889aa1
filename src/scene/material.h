#pragma once
#include <memory>

#include "base/result.h"
#include "scene/lambert.h"
#include "scene/reading/args.h"
#include "scene/scatterer.h"

namespace flatray {

/// A kind of material: one file in materials/, registered in CMake.
struct MaterialType {
  const char* name;
  const char* summary;  ///< one line, no full stop
  std::span<const KeyInfo> keys;
  Result<std::unique_ptr<const Scatterer>> (*build)(Args&);
};

/// Registered kinds by name.
std::vector<const MaterialType*> material_types();

/// How much light comes back, by colour: the part of the largest channel, and what is then left of
/// the others.
struct Reflectance {
  double part = 1;
  std::array<float, 3> tint{1, 1, 1};
};
/// The keys of it, and how they are read. Error   noted: not between 0 and 1.
inline constexpr KeyInfo kReflectanceKeys[] = {{"reflectance", "number", "1"},
                                               {"colour", "\"#rrggbb\"", "\"#ffffff\""}};
Reflectance read_reflectance(Args& args, const char* key = "reflectance");

/// What sends on `shares` of the light, in the order in which they stand.
std::unique_ptr<const Scatterer> mixture(const LightShares& shares,
                                         Material for_rays = Material::absorb);

/// Builds what sends on its light in one way.
template <double LightShares::*way, Material for_rays = Material::absorb>
Result<std::unique_ptr<const Scatterer>> build_one_way(Args& args) {
  const Reflectance light = read_reflectance(args);
  LightShares shares{.tint = light.tint};
  shares.*way = light.part;
  return mixture(shares, for_rays);
}

/// The first thing of glass; nullptr: there is none.
const Place* place_of_glass(const Scene& scene);

/// Reads one of `words` or `{ MATERIAL = { ... } }`.
struct ReadMaterial {
  Material material;
  ScattererId scatterer = kNoEntry;
};
inline constexpr Word<Material> kMaterialWords[] = {{"absorb", Material::absorb},
                                                    {"mirror", Material::mirror}};
std::optional<ReadMaterial> read_material(Builder& builder, const Field& field,
                                          std::span<const Word<Material>> words = kMaterialWords);

}  // namespace flatray
