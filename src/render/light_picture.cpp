#include "render/light_picture.h"

#include <algorithm>
#include <limits>

#include "base/check.h"
#include "image/light_film.h"
#include "scene/scatterer.h"
#include "transport/light/traced_light.h"

namespace flatray {
namespace {

double luminance(const double* rgb) { return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]; }

}  // namespace

double automatic_exposure(std::span<const double> fluence) {
  std::vector<double> lit;
  for (std::size_t i = 0; i + 2 < fluence.size(); i += 3)
    if (const double y = luminance(&fluence[i]); y > 0) lit.push_back(y);
  if (lit.empty()) return 1;
  const auto place = lit.begin() + static_cast<std::ptrdiff_t>(lit.size() - 1 - lit.size() / 100);
  std::nth_element(lit.begin(), place, lit.end());
  return 1 / *place;
}

const char* name(ToneCurve curve) {
  switch (curve) {
    case ToneCurve::linear:
      return "linear";
    case ToneCurve::soft:
      return "soft";
    case ToneCurve::filmic:
      return "filmic";
  }
  unreachable();
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

LightPicture light_picture(std::span<const double> counts, double unit, const LightSettings& light,
                           bool raw) {
  // Of sums and unit apart, as their product may be beyond the doubles.
  const double exposure = raw              ? unit
                          : light.exposure ? *light.exposure * unit
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

int light_channels(const Scene& scene) {
  const bool grey = std::all_of(scene.lamps.begin(), scene.lamps.end(),
                                [](const Lamp& lamp) {
                                  const Paint& colour = lamp.colour;
                                  return !lamp.wavelength && !lamp.temperature &&
                                         colour.curve == kNoEntry && colour.r == colour.g &&
                                         colour.g == colour.b;
                                }) &&
                    std::none_of(scene.scatterers.begin(), scene.scatterers.end(),
                                 [](const auto& scatterer) { return scatterer->colours(); });
  return grey ? 1 : 3;
}

std::uint64_t light_bytes(const Scene& scene, unsigned threads) {
  const Film& film = scene.film;
  constexpr std::uint64_t kBytesOfPixel =
      3 * (sizeof(std::int64_t) + sizeof(double) + sizeof(float));
  constexpr std::uint64_t kBytesOfRay = 512;  // under way, where it arrives, its line
  const std::uint64_t pixels =
      static_cast<std::uint64_t>(film.width) * static_cast<std::uint64_t>(film.height);
  const std::uint64_t films = scene.light.scrambles;
  const std::uint64_t sums_at_once = films == 1 ? 0 : films * 3 * sizeof(std::int64_t);
  return LightFilm::bytes(film.width, film.height, light_channels(scene), threads,
                          scene.light.scrambles) +
         (kBytesOfPixel + sums_at_once) * pixels +
         kBytesOfRay * (std::min(scene.light.rays, kLightRound) + films * scene.lamps.size());
}

}  // namespace flatray
