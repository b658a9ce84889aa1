#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "image/film_rounds.h"

namespace flatray {

/// Light as a file keeps it: whole numbers, so that files of parts of the rays add up to the file of
/// all, byte by byte, in any order.
struct FilmFile {
  struct Scramble {
    std::uint64_t lines = 0;
    std::vector<std::int64_t> sums;  ///< LightFilm::sums
    bool operator==(const Scramble&) const = default;
  };

  std::string setting;  ///< all that the bytes depend on but the rounds, as one line of JSON
  int width = 0, height = 0, channels = 3;
  double round_unit = 0;  ///< TracedLight::round_unit
  FilmRounds rounds{};
  std::vector<std::int64_t> counts{};  ///< what else is counted, by its writer
  std::vector<Scramble> scrambles{};
  bool operator==(const FilmFile&) const = default;
};

inline constexpr std::string_view kFilmSignature = "flatray film 1\n";

/// The signature; eleven numbers of 64 bits (bytes of the setting, width, height, channels, scrambles,
/// words of rounds, counts, bytes of a sum, bits of `round_unit`, 0, 0); setting, words and counts; of
/// each scramble its lines and sums; and FNV-1a of all of that. The lowest byte comes first.
std::vector<std::byte> encode_film(const FilmFile& film);

/// Error   Trouble::invalid for what `encode_film` does not write, and for sums that so few lines
///         cannot have; before anything is allocated where the file is shorter or longer than its
///         header says. Cost    at most eight times the size of the file.
Result<FilmFile> decode_film(std::span<const std::byte> bytes, const std::string& name);

/// Adds a film of other rounds of the same light.
/// Error   Trouble::invalid at `name`, that of `more`: another setting or size, a round that is in
///         both, more lines than a film counts. `film` is then as it was.
Result<void> add_film(FilmFile& film, const FilmFile& more, const std::string& name);

}  // namespace flatray
