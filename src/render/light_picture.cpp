#include "render/light_picture.h"

#include <algorithm>
#include <limits>

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

double luminance(const double* rgb) { return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]; }

}  // namespace

double automatic_exposure(const std::vector<double>& fluence) {
  std::vector<double> lit;
  for (std::size_t i = 0; i + 2 < fluence.size(); i += 3)
    if (const double y = luminance(&fluence[i]); y > 0) lit.push_back(y);
  if (lit.empty()) return 1;
  const auto place = lit.begin() + static_cast<std::ptrdiff_t>(lit.size() - 1 - lit.size() / 100);
  std::nth_element(lit.begin(), place, lit.end());
  return 1 / *place;
}

float toned(ToneCurve curve, double light) {
  constexpr double kMost = 1e6;  // far beyond white
  const double x = std::min(light, kMost);
  switch (curve) {
    case ToneCurve::linear:
      return static_cast<float>(x);
    case ToneCurve::soft:  // Reinhard et al. 2002, white at 4
      return static_cast<float>(std::min(x * (1 + x / 16) / (1 + x), 1.0));
    case ToneCurve::filmic:  // as fitted by Narkowicz 2015
      return static_cast<float>(
          std::min(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 1.0));
  }
  unreachable();
}

LightPicture light_picture(const TracedLight& traced, const LightSettings& light, bool raw) {
  const std::vector<std::int64_t> sums = traced.film.sums();
  std::vector<double> counts(sums.begin(), sums.end());
  // Of sums and unit apart, as their product may be beyond the doubles.
  const double exposure = raw              ? traced.unit
                          : light.exposure ? *light.exposure * traced.unit
                                           : automatic_exposure(counts);
  constexpr auto kMost = static_cast<double>(std::numeric_limits<float>::max());
  LightPicture picture;
  picture.rgb.reserve(counts.size());
  for (const double count : counts) {
    const double shown = std::min(count * exposure, kMost);
    picture.rgb.push_back(raw ? static_cast<float>(shown) : toned(light.tone, shown));
  }
  return picture;
}

std::uint64_t light_bytes(const Scene& scene, unsigned threads) {
  const Film& film = scene.film;
  constexpr std::uint64_t kBytesOfPixel =
      3 * (sizeof(std::int64_t) + sizeof(double) + sizeof(float));
  constexpr std::uint64_t kBytesOfRay = 512;  // under way, where it arrives, its line
  const std::uint64_t pixels =
      static_cast<std::uint64_t>(film.width) * static_cast<std::uint64_t>(film.height);
  return LightFilm::bytes(film.width, film.height, 3, threads) + kBytesOfPixel * pixels +
         kBytesOfRay * (std::min(scene.light.rays, kLightBlock) + scene.lamps.size());
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
