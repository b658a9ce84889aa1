#include "scene/lamp.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/scatterer.h"

namespace flatray {

#include "lamps.inc"  // lamp_types()

namespace {

struct Wall {
  std::string_view what, name;
  Material material;
  ScattererId scatterer;
  Place where;
};

std::vector<Wall> walls_of(const Scene& scene) {
  std::vector<Wall> walls;
  for (const Entity& one : scene.entities)
    if (one.material)
      walls.push_back({"entity", one.name, *one.material, one.scatterer, one.where});
  for (const Chamber& one : scene.chambers) {
    walls.push_back({"chamber", one.name, one.material, one.scatterer, one.where});
    for (const Chamber::Pillar& pillar : one.pillars)
      walls.push_back({"pillar", pillar.name, pillar.material, pillar.scatterer, one.where});
  }
  return walls;
}

// Whether light that leaves it in one direction has come from one.
bool is_specular(const Scene& scene, const Wall& wall) {
  if (wall.scatterer == kNoEntry) return wall.material == Material::mirror;
  const LightShares* shares = scene.scatterers[wall.scatterer]->shares();
  return shares == nullptr || shares->mirror > 0;
}

bool is_ever_one_ray(const Scene& scene, const Lamp& lamp) {
  std::set<double> times = key_times(scene, lamp.source);
  times.insert(0);
  return std::ranges::any_of(times, [&](double time) {
    const auto emitter = emitter_at(scene, lamp, time);
    return emitter != nullptr && emitter->is_one_ray();
  });
}

Diagnostic against_backward(const Place& where, std::string message) {
  return {where, std::move(message),
          "say --estimator forward, or estimator = \"forward\" in [light]"};
}

}  // namespace

std::set<CurveId> curves_of(const KeptArguments& kept) {
  std::set<CurveId> all;
  for (const KeptArguments::Argument& argument : kept.arguments)
    for (const Moving& number : argument.numbers)
      if (number.curve) all.insert(*number.curve);
  return all;
}

std::set<double> key_times(const Scene& scene, const KeptArguments& kept) {
  std::set<double> times;
  for (const CurveId curve : curves_of(kept)) {
    const std::vector<double>& keys = scene.curves[curve].times;
    times.insert(keys.begin(), keys.end());
  }
  return times;
}

std::optional<Diagnostic> why_noisy_backward(const Scene& scene) {
  for (const Wall& wall : walls_of(scene)) {
    const LightShares* shares =
        wall.scatterer == kNoEntry ? nullptr : scene.scatterers[wall.scatterer]->shares();
    if (shares != nullptr && shares->isotropic > 0)
      return against_backward(
          wall.where, fmt::format("paths from pixels have noise without bounds near {}, which "
                                  "scatters alike into all directions",
                                  called(wall.what, wall.name, wall.where)));
  }
  return std::nullopt;
}

std::optional<Diagnostic> why_not_backward(const Scene& scene) {
  const Lamp* points = nullptr;
  for (const Lamp& lamp : scene.lamps) {
    if (lamp.type->seen == LampSeen::never)
      return against_backward(
          lamp.where, fmt::format("no path from a pixel finds the light of {}, whose source is {}",
                                  called("lamp", lamp.name, lamp.where), lamp.type->name));
    if (is_ever_one_ray(scene, lamp))
      return against_backward(
          lamp.where,
          fmt::format("no path from a pixel finds the light of {}, a {} that is one ray",
                      called("lamp", lamp.name, lamp.where), lamp.type->name));
    if (lamp.type->seen == LampSeen::points && points == nullptr) points = &lamp;
  }
  for (const Entity& entity : scene.entities)
    if (!entity.alternatives.empty())
      return against_backward(entity.where,
                              fmt::format("paths from pixels do not know the alternatives of {}",
                                          called("entity", entity.name, entity.where)));
  for (const Wall& wall : walls_of(scene)) {
    if (wall.scatterer != kNoEntry && scene.scatterers[wall.scatterer]->disperses())
      return against_backward(
          wall.where, fmt::format("paths from pixels have no wavelength, and {} parts colours",
                                  called(wall.what, wall.name, wall.where)));
    if (wall.scatterer != kNoEntry && scene.scatterers[wall.scatterer]->depends_on_place())
      return against_backward(wall.where,
                              fmt::format("no path goes back by way of {}, whose mirror is turned",
                                          called(wall.what, wall.name, wall.where)));
    if (points != nullptr && is_specular(scene, wall))
      return against_backward(
          points->where,
          fmt::format("no path from a pixel finds the light of {}, a {}, by way of {}, which "
                      "sends it on in one direction",
                      called("lamp", points->name, points->where), points->type->name,
                      called(wall.what, wall.name, wall.where)));
  }
  return std::nullopt;
}

std::vector<const LampLight*> lights_of(const Lamp& lamp) {
  std::vector<const LampLight*> lights{&lamp};
  if (lamp.markov)
    for (const std::vector<Look>& looks : lamp.markov->looks)
      for (const Look& look : looks) lights.push_back(look.light.get());
  return lights;
}

std::unique_ptr<const Emitter> emitter_at(const Scene& scene, const Lamp& lamp, double time) {
  Args args(scene, lamp.source, time);
  Result<std::unique_ptr<const Emitter>> emitter = lamp.type->build(args);
  return emitter && !args.gone() ? std::move(*emitter) : nullptr;
}

}  // namespace flatray
