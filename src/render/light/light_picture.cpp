#include "render/light/light_picture.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "anim/world.h"
#include "base/check.h"
#include "base/light.h"
#include "base/portable_math.h"
#include "image/light_film.h"
#include "scene/lamp.h"
#include "scene/scatterer.h"
#include "scene/spectrum.h"
#include "transport/light/traced_light.h"

namespace flatray {
namespace {

double luminance_of(const double* rgb) {
  return flatray::luminance(LightColour{rgb[0], rgb[1], rgb[2]});
}

}  // namespace

double automatic_exposure(std::span<const double> fluence) {
  std::vector<double> lit;
  for (std::size_t i = 0; i + 2 < fluence.size(); i += 3)
    if (const double y = luminance_of(&fluence[i]); y > 0) lit.push_back(y);
  if (lit.empty()) return 1;
  const std::size_t bright = std::max<std::size_t>(lit.size() / 100, 1);
  const auto place = lit.end() - static_cast<std::ptrdiff_t>(bright);
  std::nth_element(lit.begin(), place, lit.end());
  return 1 / *place;
}

const char* name(ToneCurve curve) {
  for (const auto& [word, one] : kToneCurves)
    if (one == curve) return word;
  unreachable();
}

float toned(ToneCurve curve, double light) {
  constexpr double kMost = 1e6;  // far beyond white
  const double x = std::min(light, kMost);
  switch (curve) {
    case ToneCurve::linear:
    case ToneCurve::gamma:  // GammaCurve
      return static_cast<float>(x);
    case ToneCurve::soft:  // Reinhard et al. 2002, white at 4
      return static_cast<float>(std::min(x * (1 + x / 16) / (1 + x), 1.0));
    case ToneCurve::filmic:  // as fitted by Narkowicz 2015
      return static_cast<float>(
          std::min(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 1.0));
  }
  unreachable();
}

GammaCurve::GammaCurve(double gamma) {
  for (std::uint32_t i = 0; i < shown_.size(); ++i) {
    const auto light = static_cast<double>(std::bit_cast<float>((i + kFirst) << kShift));
    shown_[i] = static_cast<float>(light_of(255 * portable::pow(light, 1 / gamma)));
  }
}

float GammaCurve::operator()(double light) const {
  const auto x = static_cast<float>(light);
  if (!(x < 1)) return 1;
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(x), knot = bits >> kShift;
  if (x < 0 || knot < kFirst) return 0;
  const float part = static_cast<float>(bits & kRest) / static_cast<float>(kRest + 1);
  const float low = shown_[knot - kFirst];
  return low + part * (shown_[knot - kFirst + 1] - low);
}

LightPicture light_picture(std::span<const double> counts, double unit, const LightSettings& light,
                           bool raw) {
  // Of sums and unit apart, as their product may be beyond the doubles.
  const double exposure = raw              ? unit
                          : light.exposure ? *light.exposure * unit
                                           : automatic_exposure(counts);
  constexpr auto kMost = static_cast<double>(std::numeric_limits<float>::max());
  LightPicture picture;
  picture.rgb.reserve(counts.size());
  if (!raw && light.tone == ToneCurve::gamma) {
    const GammaCurve curve(light.gamma);
    for (const double count : counts) picture.rgb.push_back(curve(count * exposure));
    return picture;
  }
  for (const double count : counts) {
    const double shown = std::min(count * exposure, kMost);
    picture.rgb.push_back(raw ? static_cast<float>(shown) : toned(light.tone, shown));
  }
  return picture;
}

int light_channels(const Scene& scene) {
  const auto is_grey = [](const LampLight* light) {
    const Paint& colour = light->colour;
    return !light->wavelength && !light->temperature && !light->spectrum &&
           colour.curve == kNoEntry && colour.r == colour.g && colour.g == colour.b;
  };
  const bool grey = std::all_of(scene.lamps.begin(), scene.lamps.end(),
                                [&](const Lamp& lamp) {
                                  const auto lights = lights_of(lamp);
                                  return std::all_of(lights.begin(), lights.end(), is_grey);
                                }) &&
                    std::none_of(scene.scatterers.begin(), scene.scatterers.end(),
                                 [](const auto& scatterer) { return scatterer->colours(); });
  return grey ? 1 : 3;
}

namespace {

// Walls of a frame, or a few more.
std::uint64_t most_walls(const Scene& scene) {
  const auto walls = [&](ShapeId id) {
    const Shape& shape = scene.shapes[id];
    std::uint64_t count =
        shape.vertices.size() + shape.circles.size() + shape.segments.size() + shape.beziers.size();
    for (const ArcPath& path : shape.arc_paths) count += 2 * path.arcs.size();
    return count;
  };
  std::uint64_t count = 0;
  for (const Entity& entity : scene.entities)
    if (entity.material && entity.shape < scene.shapes.size()) count += walls(entity.shape);
  for (const Chamber& chamber : scene.chambers) {
    count += walls(chamber.shape);
    for (const Chamber::Pillar& pillar : chamber.pillars) count += walls(pillar.shape);
  }
  return count;
}

}  // namespace

std::uint64_t light_bytes(const Scene& scene, unsigned threads) {
  const Film& film = scene.film;
  constexpr std::uint64_t kBytesOfPixel =
      3 * (sizeof(std::int64_t) + sizeof(double) + sizeof(float));
  constexpr std::uint64_t kBytesOfRay = 512;  // under way, where it arrives, its line
  constexpr std::uint64_t kBytesOfWall =
      640;  // with its owner, its neighbours and its part of a tracer
  const std::uint64_t pixels =
      static_cast<std::uint64_t>(film.width) * static_cast<std::uint64_t>(film.height);
  constexpr std::uint64_t kBytesOfPieces = std::uint64_t{1} << 26;  // of rays that fade
  const bool absorbs =
      std::any_of(scene.scatterers.begin(), scene.scatterers.end(), [](const auto& scatterer) {
        return scatterer->absorption() != std::array<double, 3>{0, 0, 0};
      });
  const std::uint64_t films = scene.light.scrambles;
  const std::uint64_t sums_at_once = films == 1 ? 0 : films * 3 * sizeof(std::int64_t);
  return LightFilm::bytes(film.width, film.height, light_channels(scene), threads,
                          scene.light.scrambles) +
         (kBytesOfPixel + sums_at_once) * pixels + (absorbs ? kBytesOfPieces : 0) +
         kBytesOfWall * count_of_worlds(scene) * most_walls(scene) +
         kBytesOfRay * (std::min(scene.light.rays, kLightRound) + films * scene.lamps.size());
}

}  // namespace flatray
