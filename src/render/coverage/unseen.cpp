#include "render/coverage/unseen.h"

#include <fmt/core.h>

#include <algorithm>

#include "anim/lamps.h"
#include "anim/rays.h"
#include "anim/solids.h"
#include "render/light/light_run.h"
#include "render/ray_walls.h"
#include "scene/scatterer.h"

namespace flatray {
namespace {

constexpr std::uint64_t kTrialRays = 1024;
constexpr unsigned kTrialBounces = 32;

// Of the rays of one table the first.
void add_rays(const Scene& scene, const FrameState& state, Diagnostics& warnings) {
  if (!need_of_ray_walls(scene).needed) return;
  const RayWalls walls(scene, state, nullptr);
  std::optional<std::size_t> told;
  for (const RayState& now : ray_states(scene, state)) {
    const RayPath& ray = scene.rays[now.ray];
    if (ray.speed || told == ray.where.offset) continue;
    const OrbitEnd end = trace_orbits(walls.orbits(), std::span(&now.start, 1), 0).front().end;
    if (end != OrbitEnd::corner && end != OrbitEnd::along) continue;
    told = ray.where.offset;
    warnings.push_back(
        {ray.where,
         fmt::format("{} draws nothing in frame 1: it starts {}",
                     called("ray", ray.name, ray.where),
                     end == OrbitEnd::corner ? "at an end of a wall, or where walls meet"
                                             : "on a wall and runs along it"),
         "let it start beside the wall"});
  }
}

// Of what a lamp stands in.
struct Around {
  std::string name;
  const Scatterer* scatterer;
  Material material;
  bool covers;  // by an opaque fill above the light

  bool absorbs() const { return scatterer == nullptr && material == Material::absorb; }
};

template <class Thing>
Around around(const Scene& scene, const Thing& thing, const char* what, int layer,
              Material material) {
  const bool opaque = thing.fill && thing.fill->a == 255 && thing.fill->gradient == kNoEntry &&
                      thing.fill->curve == kNoEntry;
  return {called(what, thing.name, thing.where),
          thing.scatterer == kNoEntry ? nullptr : scene.scatterers[thing.scatterer].get(), material,
          opaque && layer >= scene.light.layer};
}

Around around(const Scene& scene, const SurfaceOwner& owner) {
  if (owner.kind == SurfaceOwner::Kind::entity) {
    const Entity& entity = scene.entities[owner.index];
    return around(scene, entity, "entity", entity.layer, owner.material);
  }
  const Chamber& chamber = scene.chambers[owner.index];
  return around(scene, chamber.pillars[owner.pillar], "pillar", chamber.layer, owner.material);
}

// Whether what shines outside of the chambers stays there.
bool keeps_out(const Scene& scene) {
  return std::all_of(scene.chambers.begin(), scene.chambers.end(), [](const Chamber& chamber) {
    return chamber.scatterer == kNoEntry || chamber.material == Material::mirror;
  });
}

// Of the lamps of one table the first.
void add_lamps(const Scene& scene, const FrameState& state, std::span<const LampState> lamps,
               Diagnostics& warnings) {
  const Solids solids(scene, state);
  std::optional<std::size_t> told;
  for (const LampState& now : lamps) {
    const Lamp& lamp = scene.lamps[now.lamp];
    if (told == lamp.where.offset) continue;
    const auto tell = [&](const std::string& what) {
      told = lamp.where.offset;
      warnings.push_back(
          {lamp.where, called("lamp", lamp.name, lamp.where) + what, "move it into the open"});
    };
    if (const auto owner = solids.holder(now.pose.at)) {
      const Around body = around(scene, *owner);
      if (body.absorbs())
        tell(" stands inside " + body.name + ", which absorbs its light, in frame 1");
      else if (body.covers)
        tell(" stands inside " + body.name + ", whose fill covers its light, in frame 1");
    } else if (solids.has_chamber() && keeps_out(scene) && !solids.in_chamber(now.pose.at)) {
      tell(" stands outside the chamber, which its light does not enter, in frame 1");
    }
  }
}

// Whether light does, as far as a few rays tell.
bool reaches_film(const Scene& scene, const FrameState& state, std::uint64_t seed) {
  constexpr std::int64_t kWidth = 8, kMostSide = 65536;  // of a LightFilm
  const std::int64_t width = scene.film.width, height = scene.film.height;
  Scene small = scene;
  const std::int64_t across = std::clamp<std::int64_t>(kMostSide * width / height, 1, kWidth);
  small.film.width = static_cast<int>(across);
  small.film.height = static_cast<int>(std::max<std::int64_t>(across * height / width, 1));
  small.light.rays = kTrialRays;
  small.light.scrambles = 1;
  small.light.bounces = std::min(scene.light.bounces, kTrialBounces);
  small.light.estimator = LightEstimator::automatic;
  const std::vector<double> fluence = frame_fluence(small, state, nullptr, seed, {});
  if (std::ranges::any_of(fluence, [](double one) { return one > 0; })) return true;
  // So few rays need not come to a small part of the room.
  return !is_gathered(small, state) &&
         shows_little(small, state, bounds_of(build_world(small, state).surfaces));
}

}  // namespace

Diagnostics unseen_in(const Scene& scene, std::uint64_t seed) {
  Diagnostics warnings;
  if (scene.rays.empty() && scene.lamps.empty()) return warnings;
  const FrameState state = at(Timeline(scene, seed, 1), 1);
  add_rays(scene, state, warnings);
  const std::vector<LampState> lamps = lamp_states(scene, state);
  if (lamps.empty()) return warnings;
  const std::size_t before = warnings.size();
  add_lamps(scene, state, lamps, warnings);
  if (warnings.size() == before && !reaches_film(scene, state, seed))
    warnings.push_back({scene.lamps[lamps.front().lamp].where,
                        "no light is seen in frame 1, as far as a few rays tell",
                        "turn the lamp to what the film shows, or move the film"});
  return warnings;
}

}  // namespace flatray
