#include "scene/spectrum.h"

#include <algorithm>
#include <numbers>

#include "base/portable_math.h"

namespace flatray {
namespace {

struct Xyz {
  double x = 0, y = 0, z = 0;
};

// The eye of the CIE's standard observer of 1931, in steps from the first to the last wavelength.
constexpr double kFirst_nm = 360, kLast_nm = 830, kStep_nm = 5;
constexpr std::size_t kSteps = 94;
constexpr double kEye[3][kSteps + 1] = {
    {0.0001299,      0.0002321,      0.0004149,      0.0007416,      0.001368,      0.002236,
     0.004243,       0.00765,        0.01431,        0.02319,        0.04351,       0.07763,
     0.13438,        0.21477,        0.2839,         0.3285,         0.34828,       0.34806,
     0.3362,         0.3187,         0.2908,         0.2511,         0.19536,       0.1421,
     0.09564,        0.05795,        0.03201,        0.0147,         0.0049,        0.0024,
     0.0093,         0.0291,         0.06327,        0.1096,         0.1655,        0.22575,
     0.2904,         0.3597,         0.43345,        0.51205,        0.5945,        0.6784,
     0.7621,         0.8425,         0.9163,         0.9786,         1.0263,        1.0567,
     1.0622,         1.0456,         1.0026,         0.9384,         0.85445,       0.7514,
     0.6424,         0.5419,         0.4479,         0.3608,         0.2835,        0.2187,
     0.1649,         0.1212,         0.0874,         0.0636,         0.04677,       0.0329,
     0.0227,         0.01584,        0.01135916,     0.008110916,    0.005790346,   0.004109457,
     0.002899327,    0.00204919,     0.001439971,    0.0009999493,   0.0006900786,  0.0004760213,
     0.0003323011,   0.0002348261,   0.0001661505,   0.000117413,    0.00008307527, 0.00005870652,
     0.00004150994,  0.00002935326,  0.00002067383,  0.00001455977,  0.00001025398, 0.000007221456,
     0.000005085868, 0.000003581652, 0.000002522525, 0.000001776509, 0.000001251141},
    {0.000003917,  0.000006965,  0.00001239,    0.00002202,    0.000039,
     0.000064,     0.00012,      0.000217,      0.000396,      0.00064,
     0.00121,      0.00218,      0.004,         0.0073,        0.0116,
     0.01684,      0.023,        0.0298,        0.038,         0.048,
     0.06,         0.0739,       0.09098,       0.1126,        0.13902,
     0.1693,       0.20802,      0.2586,        0.323,         0.4073,
     0.503,        0.6082,       0.71,          0.7932,        0.862,
     0.91485,      0.954,        0.9803,        0.99495,       1,
     0.995,        0.9786,       0.952,         0.9154,        0.87,
     0.8163,       0.757,        0.6949,        0.631,         0.5668,
     0.503,        0.4412,       0.381,         0.321,         0.265,
     0.217,        0.175,        0.1382,        0.107,         0.0816,
     0.061,        0.04458,      0.032,         0.0232,        0.017,
     0.01192,      0.00821,      0.005723,      0.004102,      0.002929,
     0.002091,     0.001484,     0.001047,      0.00074,       0.00052,
     0.0003611,    0.0002492,    0.0001719,     0.00012,       0.0000848,
     0.00006,      0.0000424,    0.00003,       0.0000212,     0.00001499,
     0.0000106,    0.0000074657, 0.0000052578,  0.0000037029,  0.0000026078,
     0.0000018366, 0.0000012934, 0.00000091093, 0.00000064153, 0.00000045181},
    {0.0006061, 0.001086, 0.001946, 0.003486, 0.00645, 0.01055, 0.02005, 0.03621, 0.06785, 0.1102,
     0.2074,    0.3713,   0.6456,   1.03905,  1.3856,  1.62296, 1.74706, 1.7826,  1.77211, 1.7441,
     1.6692,    1.5281,   1.28764,  1.0419,   0.81295, 0.6162,  0.46518, 0.3533,  0.272,   0.2123,
     0.1582,    0.1117,   0.07825,  0.05725,  0.04216, 0.02984, 0.0203,  0.0134,  0.00875, 0.00575,
     0.0039,    0.00275,  0.0021,   0.0018,   0.00165, 0.0014,  0.0011,  0.001,   0.0008,  0.0006,
     0.00034,   0.00024,  0.00019,  0.0001,   0.00005, 0.00003, 0.00002, 0.00001, 0,       0,
     0,         0,        0,        0,        0,       0,       0,       0,       0,       0,
     0,         0,        0,        0,        0,       0,       0,       0,       0,       0,
     0,         0,        0,        0,        0,       0,       0,       0,       0,       0,
     0,         0,        0,        0,        0}};

// Linear between the steps.
Xyz matching(double nm) {
  if (!(nm >= kFirst_nm && nm <= kLast_nm)) return {};
  const double steps = (nm - kFirst_nm) / kStep_nm;
  const auto step = std::min(static_cast<std::size_t>(steps), kSteps - 1);
  const double part = steps - static_cast<double>(step);
  const auto at = [&](const double* eye) { return eye[step] + part * (eye[step + 1] - eye[step]); };
  return {at(kEye[0]), at(kEye[1]), at(kEye[2])};
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
constexpr double kGreen_nm = 560;
constexpr double kLeastKelvin = 800, kMostKelvin = 100'000;

// The sum over steps of a blackbody's light, in parts of its radiance at kGreen_nm, so that nothing is
// beyond the doubles.
Xyz seen_of(double kelvin) {
  const double t = std::clamp(kelvin, kLeastKelvin, kMostKelvin);
  Xyz sum;
  for (std::size_t step = 0; step <= kSteps; ++step) {
    const double nm = kFirst_nm + kStep_nm * static_cast<double>(step);
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

LightColour colour_of_wavelength(double nm) { return shown(srgb_of(matching(nm))); }

LightColour part_of_wavelength(double nm) {
  static const LightColour scale = [] {
    LightColour sum{0, 0, 0};
    constexpr int kParts = 330;
    for (int i = 0; i < kParts; ++i) {
      const double part = (i + 0.5) / kParts;
      const LightColour one =
          srgb_of(matching(kFirstWavelength + part * (kLastWavelength - kFirstWavelength)));
      for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += std::max(one[c], 0.0) / kParts;
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
