#pragma once
#include "base/result.h"
#include "scene/spectrum.h"

namespace flatray {

/// A spectrum as instruments write it: a line "wavelength, power" for each row, in nanometres and
/// any unit, parted by a comma, a semicolon or blanks. '#' begins a comment; the first line may hold
/// the names of the columns.
///
/// Error   what is no row, powers below 0, wavelengths that do not rise, fewer than two rows or more
///         than kMostSpectrumRows, nothing that is seen; each with its place, at most 20.
Result<Spectrum> parse_spectrum(const SourcePtr& source);
inline constexpr std::size_t kMostSpectrumRows = 100'000;

}  // namespace flatray
