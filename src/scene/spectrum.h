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

/// Light of all colours together, taken apart: how much of red, green and blue goes to a wavelength,
/// so that their means over [kFirstWavelength, kLastWavelength] are 1. None is below 0; at most
/// kMostOfWavelength.
inline constexpr double kFirstWavelength = 390, kLastWavelength = 720;
inline constexpr double kMostOfWavelength = 6;
LightColour part_of_wavelength(double nm);

}  // namespace flatray
