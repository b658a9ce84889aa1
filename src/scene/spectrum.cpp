#include "scene/spectrum.h"

#include <algorithm>
#include <numbers>

#include "base/portable_math.h"

namespace flatray {
namespace {

constexpr double kFirst_nm = 360, kLast_nm = 830;

// One lobe of a fit: wider on one side than on the other.
double lobe(double nm, double peak, double left, double right) {
  const double z = (nm - peak) / (nm < peak ? left : right);
  return portable::exp(-0.5 * z * z);
}

struct Xyz {
  double x = 0, y = 0, z = 0;
};

Xyz matching(double nm) {
  return {1.056 * lobe(nm, 599.8, 37.9, 31.0) + 0.362 * lobe(nm, 442.0, 16.0, 26.7) -
              0.065 * lobe(nm, 501.1, 20.4, 26.2),
          0.821 * lobe(nm, 568.8, 46.9, 40.5) + 0.286 * lobe(nm, 530.9, 16.3, 31.1),
          1.217 * lobe(nm, 437.0, 11.8, 36.0) + 0.681 * lobe(nm, 459.0, 26.0, 13.8)};
}

// IEC 61966-2-1.
LightColour srgb_of(const Xyz& c) {
  return {3.2406 * c.x - 1.5372 * c.y - 0.4986 * c.z, -0.9689 * c.x + 1.8758 * c.y + 0.0415 * c.z,
          0.0557 * c.x - 0.2040 * c.y + 1.0570 * c.z};
}

// White is mixed in until no channel is below 0.
LightColour within_srgb(LightColour colour) {
  const double least = std::min(0.0, *std::ranges::min_element(colour));
  for (double& channel : colour) channel -= least;
  return colour;
}

LightColour shown(LightColour colour) {
  colour = within_srgb(colour);
  const double most = *std::ranges::max_element(colour);
  for (double& channel : colour) channel = most > 0 ? channel / most : 0;
  return colour;
}

constexpr double kSecond_nm = 1.438776877e7;  // Planck's second constant, nm K
constexpr double kStep_nm = 5, kGreen_nm = 560;
constexpr int kPlanckSteps = static_cast<int>((kLast_nm - kFirst_nm) / kStep_nm);
constexpr double kLeastKelvin = 800, kMostKelvin = 100'000;

// The sum over steps of a blackbody's light, in parts of its radiance at kGreen_nm, so that nothing is
// beyond the doubles.
Xyz seen_of(double kelvin) {
  const double t = std::clamp(kelvin, kLeastKelvin, kMostKelvin);
  Xyz sum;
  for (int step = 0; step <= kPlanckSteps; ++step) {
    const double nm = kFirst_nm + step * kStep_nm;
    const double ratio = kGreen_nm / nm, fifth = ratio * ratio * ratio * ratio * ratio;
    const double part = fifth * (1 - portable::exp(-kSecond_nm / (kGreen_nm * t))) /
                        (1 - portable::exp(-kSecond_nm / (nm * t))) *
                        portable::exp(kSecond_nm / t * (1 / kGreen_nm - 1 / nm));
    const Xyz eye = matching(nm);
    sum = {sum.x + part * eye.x, sum.y + part * eye.y, sum.z + part * eye.z};
  }
  return sum;
}

}  // namespace

// Towards both ends the eye tells hardly any hues apart, and the lobes have none that are right.
LightColour colour_of_wavelength(double nm) {
  constexpr double kFirstHue_nm = 420, kLastHue_nm = 645;
  if (!(nm >= kFirst_nm && nm <= kLast_nm)) return {0, 0, 0};
  return shown(srgb_of(matching(std::clamp(nm, kFirstHue_nm, kLastHue_nm))));
}

LightColour part_of_wavelength(double nm) {
  static const LightColour scale = [] {
    LightColour sum{0, 0, 0};
    constexpr int kSteps = 330;
    for (int i = 0; i < kSteps; ++i) {
      const double part = (i + 0.5) / kSteps;
      const LightColour one =
          srgb_of(matching(kFirstWavelength + part * (kLastWavelength - kFirstWavelength)));
      for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += std::max(one[c], 0.0) / kSteps;
    }
    for (double& channel : sum) channel = 1 / channel;
    return sum;
  }();
  LightColour part = srgb_of(matching(nm));
  for (std::size_t c = 0; c < part.size(); ++c) part[c] = std::max(part[c], 0.0) * scale[c];
  return part;
}

LightColour colour_of_temperature(double kelvin) { return shown(srgb_of(seen_of(kelvin))); }

double luminance_of_wavelength(double nm) { return matching(nm).y; }

double luminance_of_temperature(double kelvin) {
  // The integral of Planck's law over all wavelengths, in the units of seen_of().
  const double t = std::clamp(kelvin, kLeastKelvin, kMostKelvin), x = kSecond_nm / (kGreen_nm * t);
  constexpr double kFourth =
      std::numbers::pi * std::numbers::pi * std::numbers::pi * std::numbers::pi;
  const double all =
      kFourth / 15 * kGreen_nm * portable::exp(x) * (1 - portable::exp(-x)) / (x * x * x * x);
  return kStep_nm * seen_of(kelvin).y / all;
}

Spectrum::Spectrum(std::span<const Row> rows) {
  for (std::size_t i = 1; i < rows.size(); ++i) add_cells(rows[i - 1], rows[i]);
  LightColour sum{0, 0, 0};  // of what is in them, taken apart
  for (const Cell& cell : cells_)
    for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += cell.light[c];
  double chances = 0;  // of all cells: each has that of its brightest channel
  for (Cell& cell : cells_) {
    for (std::size_t c = 0; c < sum.size(); ++c)
      cell.light[c] = sum[c] > 0 ? cell.light[c] / sum[c] : 0;
    chances += *std::ranges::max_element(cell.light);
    cell.end = chances;
  }
  if (chances == 0) cells_.clear();
  for (Cell& cell : cells_) cell.end /= chances;
  colour_ = shown(colour_);
}

// Between two rows, at most a nanometre each, integrated by Simpson's rule.
void Spectrum::add_cells(const Row& from, const Row& to) {
  const double begin = std::max(from.nm, kLeastSeen), end = std::min(to.nm, kMostSeen);
  if (!(begin < end) || (from.power == 0 && to.power == 0)) return;
  const auto count = static_cast<int>(end - begin) + 1;
  const auto at = [&](double cell) { return begin + cell / count * (end - begin); };
  for (int i = 0; i < count; ++i) {
    Cell& cell = cells_.emplace_back(Cell{at(i), at(i + 1) - at(i), {0, 0, 0}, 0});
    for (const double place : {0.0, 0.5, 1.0}) {
      const double nm = at(i + place), part = (nm - from.nm) / (to.nm - from.nm);
      const double power = (1 - part) * from.power + part * to.power;
      const double weight = (place == 0.5 ? 4 : 1) * cell.width / 6 * power;
      const LightColour eye = srgb_of(matching(nm)), own = within_srgb(eye);
      for (std::size_t c = 0; c < eye.size(); ++c)
        colour_[c] += weight * eye[c], cell.light[c] += weight * own[c];
    }
  }
}

Spectrum::Part Spectrum::part(double u) const {
  const auto after = std::ranges::upper_bound(cells_, u, {}, &Cell::end);
  const auto cell = after == cells_.end() ? std::prev(after) : after;
  const double begin = cell == cells_.begin() ? 0 : std::prev(cell)->end;
  const double chance = cell->end - begin;
  Part made{cell->nm + (u - begin) / chance * cell->width, cell->light};
  for (double& channel : made.part) channel /= chance;
  return made;
}

}  // namespace flatray
