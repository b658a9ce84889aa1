#include "render/light_picture.h"

#include <algorithm>

#include "base/check.h"
#include "render/film_transform.h"

namespace flatray {
namespace {

const Scatterer* scatterer_of(const Scene& scene, const SurfaceOwner& owner) {
  using Kind = SurfaceOwner::Kind;
  const ScattererId id = owner.kind == Kind::entity ? scene.entities[owner.index].scatterer
                         : owner.kind == Kind::chamber
                             ? scene.chambers[owner.index].scatterer
                             : scene.chambers[owner.index].pillars[owner.pillar].scatterer;
  return id == kNoEntry ? nullptr : scene.scatterers[id].get();
}

float luminance(const float* rgb) { return 0.2126F * rgb[0] + 0.7152F * rgb[1] + 0.0722F * rgb[2]; }

}  // namespace

double automatic_exposure(const std::vector<float>& fluence) {
  std::vector<float> lit;
  for (std::size_t i = 0; i + 2 < fluence.size(); i += 3)
    if (const float y = luminance(&fluence[i]); y > 0) lit.push_back(y);
  if (lit.empty()) return 1;
  const auto place = lit.begin() + static_cast<std::ptrdiff_t>(lit.size() - 1 - lit.size() / 100);
  std::nth_element(lit.begin(), place, lit.end());
  return 1 / static_cast<double>(*place);
}

float toned(ToneCurve curve, float x) {
  switch (curve) {
    case ToneCurve::linear:
      return x;
    case ToneCurve::soft:  // Reinhard et al. 2002, white at 4
      return std::min(x * (1 + x / 16) / (1 + x), 1.0F);
    case ToneCurve::filmic:  // as fitted by Narkowicz 2015
      return std::min(x * (2.51F * x + 0.03F) / (x * (2.43F * x + 0.59F) + 0.14F), 1.0F);
  }
  unreachable();
}

LightPicture light_picture(const TracedLight& traced, const LightSettings& light, bool raw) {
  const std::vector<std::int64_t> sums = traced.film.sums();
  LightPicture picture;
  picture.rgb.reserve(sums.size());
  for (const std::int64_t sum : sums)
    picture.rgb.push_back(static_cast<float>(static_cast<double>(sum) * traced.unit));
  if (raw) return picture;
  const auto exposure =
      static_cast<float>(light.exposure.value_or(automatic_exposure(picture.rgb)));
  for (float& channel : picture.rgb) channel = toned(light.tone, exposure * channel);
  return picture;
}

std::uint64_t light_bytes(const Film& film, unsigned threads) {
  constexpr std::uint64_t kBytesOfPixel = 3 * (sizeof(std::int64_t) + sizeof(float));
  constexpr std::uint64_t kBytesOfRay = 512;  // under way, where it arrives, its line
  const std::uint64_t pixels =
      static_cast<std::uint64_t>(film.width) * static_cast<std::uint64_t>(film.height);
  return LightFilm::bytes(film.width, film.height, 3, threads) + kBytesOfPixel * pixels +
         kBytesOfRay * kLightBlock;
}

TracedLight trace_frame_light(const Scene& scene, const FrameState& state, const Tracer* tracer,
                              std::uint64_t seed, unsigned threads, bool (*stop)()) {
  const World world = build_world(scene, state);
  std::vector<const Scatterer*> scatterers;
  for (const SurfaceOwner& owner : world.owners) scatterers.push_back(scatterer_of(scene, owner));
  const FilmTransform film(scene.film, state);
  const FilmPlace place{film.corner().x(), film.corner().y(), film.scale(), scene.film.width,
                        scene.film.height};
  const std::vector<LampState> lamps = lamp_states(scene, state);
  if (lamps.empty()) return {LightFilm(place.width, place.height, 3), 0, {}};
  return trace_light(
      world, scatterers, lamps, place,
      {scene.light, seed, scene.light.noise_moves ? state.frame : 0, threads, tracer, stop});
}

}  // namespace flatray
