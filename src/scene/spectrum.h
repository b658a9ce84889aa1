#pragma once
#include <array>
#include <span>
#include <vector>

namespace flatray {

/// Linear sRGB.
using LightColour = std::array<double, 3>;

/// What the eye sees of light of one wavelength, as near as sRGB shows it.
///
/// Units   nm. Gives   the largest channel 1, none below 0: white is mixed in where the colour lies
///         outside of sRGB; black below 360 nm and beyond 830.
/// Source  CIE 1931 standard observer (2 degrees), its table in steps of 5 nm (CIE 018:2019), linear
///         in between.
LightColour colour_of_wavelength(double nm);

/// What the eye sees of a blackbody, from 800 K to 100 000 K; beyond these what it is there.
///
/// Units   kelvin. Gives   as above. Source  Planck's law in steps of 5 nm.
LightColour colour_of_temperature(double kelvin);

/// How bright light of power 1 is: of one wavelength, by the eye's curve, whose peak is 1; of a
/// blackbody from 800 K to 100 000 K, of all that it sends out, seen or not.
///
/// Units   nm, kelvin. Source  as above.
double luminance_of_wavelength(double nm);
double luminance_of_temperature(double kelvin);
/// The same of a colour: that of white is 1.
inline double luminance(const LightColour& colour) {
  return 0.2126 * colour[0] + 0.7152 * colour[1] + 0.0722 * colour[2];
}

/// Light of all colours together, taken apart: how much of red, green and blue goes to a wavelength,
/// so that their means over [kFirstWavelength, kLastWavelength] are 1. None is below 0; at most
/// kMostOfWavelength.
inline constexpr double kFirstWavelength = 390, kLastWavelength = 720;
inline constexpr double kMostOfWavelength = 6;
LightColour part_of_wavelength(double nm);

/// Light whose power at some wavelengths is known, in proportion between them, none beyond them.
/// Only what lies between kLeastSeen and kMostSeen counts.
class Spectrum {
 public:
  struct Row {
    double nm, power;
  };
  static constexpr double kLeastSeen = 380, kMostSeen = 780;

  /// Needs   rows with ascending wavelengths, none below 0.
  explicit Spectrum(std::span<const Row> rows);

  /// As colour_of_wavelength(); black where nothing is seen.
  const LightColour& colour() const { return colour_; }

  /// The light taken apart by chance `u`, uniform in [0, 1): a wavelength, and what part of red,
  /// green and blue goes to it. The means of the parts are 1 in channels that are not 0; none is
  /// above 3.
  struct Part {
    double nm;
    LightColour part;
  };
  Part part(double u) const;

 private:
  struct Cell {
    double nm, width;  // from nm on
    LightColour light;
    double end;  // of the numbers that stand for it
  };
  void add_cells(const Row& from, const Row& to);

  std::vector<Cell> cells_;
  LightColour colour_{0, 0, 0};
};

}  // namespace flatray
