#pragma once
#include <array>

namespace flatray {

/// Linear sRGB.
using LightColour = std::array<double, 3>;

/// What the eye sees of light of one wavelength, as near as sRGB shows it.
///
/// Units   nm. Gives   the largest channel 1, none below 0: white is mixed in where the colour lies
///         outside of sRGB; black below 360 nm and beyond 830.
/// Source  CIE 1931 as fitted by Wyman, Sloan and Shirley 2013, "Simple analytic approximations to
///         the CIE XYZ color matching functions".
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

}  // namespace flatray
