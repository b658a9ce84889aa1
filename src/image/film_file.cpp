#include "image/film_file.h"

#include <fmt/core.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "base/hash.h"
#include "image/light_film.h"

namespace flatray {
namespace {

constexpr std::uint64_t kMostSide = 65536, kMostScrambles = 64, kMostText = 65536;
constexpr std::uint64_t kMostCounts = 64;

// In the order of the file.
struct Header {
  std::uint64_t setting, width, height, channels, scrambles, words, counts, sum_bytes, unit;
  std::uint64_t zeros[2];
};
using HeaderWords = std::array<std::uint64_t, sizeof(Header) / 8>;

std::uint64_t sums_of(const Header& header) {
  return header.width * header.height * header.channels;
}

// Of the whole file. Needs   numbers in range.
std::uint64_t file_bytes(const Header& header) {
  return kFilmSignature.size() + sizeof(Header) + header.setting +
         8 * (header.words + header.counts) +
         header.scrambles * (8 + sums_of(header) * header.sum_bytes) + 8;
}

bool in_range(const Header& header) {
  const auto within = [](std::uint64_t value, std::uint64_t low, std::uint64_t high) {
    return low <= value && value <= high;
  };
  return header.setting <= kMostText && within(header.width, 1, kMostSide) &&
         within(header.height, 1, kMostSide) && (header.channels == 1 || header.channels == 3) &&
         within(header.scrambles, 1, kMostScrambles) && header.words <= FilmRounds::kMost / 64 &&
         header.counts <= kMostCounts && within(header.sum_bytes, 1, 8) && header.zeros[0] == 0 &&
         header.zeros[1] == 0;
}

// As many as the largest sum needs.
std::uint64_t bytes_of_sums(const FilmFile& film) {
  std::uint64_t any = 1;
  for (const FilmFile::Scramble& one : film.scrambles)
    for (const std::int64_t sum : one.sums) any |= static_cast<std::uint64_t>(sum);
  return (static_cast<std::uint64_t>(std::bit_width(any)) + 7) / 8;
}

void put(std::vector<std::byte>& out, std::string_view text) {
  const auto bytes = std::as_bytes(std::span(text));
  out.insert(out.end(), bytes.begin(), bytes.end());
}

void put(std::vector<std::byte>& out, std::uint64_t value, std::uint64_t bytes = 8) {
  for (std::uint64_t i = 0; i < bytes; ++i) out.push_back(static_cast<std::byte>(value >> (8 * i)));
}

// Needs   bytes enough for all that is read.
struct Reader {
  std::span<const std::byte> rest;

  std::string_view text(std::uint64_t size) {
    const auto bytes = take(size);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }
  std::uint64_t number(std::uint64_t bytes = 8) {
    std::uint64_t value = 0;
    const auto taken = take(bytes);
    for (std::uint64_t i = 0; i < bytes; ++i)
      value |= std::to_integer<std::uint64_t>(taken[i]) << (8 * i);
    return value;
  }

  std::span<const std::byte> take(std::uint64_t size) {
    const auto taken = rest.first(size);
    rest = rest.subspan(size);
    return taken;
  }
};

Header read_header(Reader& reader) {
  HeaderWords words{};
  for (std::uint64_t& word : words) word = reader.number();
  return std::bit_cast<Header>(words);
}

// False where no lines could have these sums.
bool read_scramble(Reader& reader, const Header& header, FilmFile::Scramble& scramble) {
  scramble.lines = reader.number();
  if (scramble.lines > LightFilm::kMostLines) return false;
  scramble.sums.reserve(sums_of(header));
  for (std::uint64_t i = 0; i < sums_of(header); ++i) {
    const std::uint64_t sum = reader.number(header.sum_bytes);
    if (sum != 0 && sum >= scramble.lines << 17) return false;
    scramble.sums.push_back(static_cast<std::int64_t>(sum));
  }
  return true;
}

std::uint64_t lines_of(const FilmFile& film) {
  std::uint64_t lines = 0;
  for (const FilmFile::Scramble& one : film.scrambles) lines += one.lines;
  return lines;
}

bool is_film(std::span<const std::byte> bytes) {
  return bytes.size() >= kFilmSignature.size() &&
         std::memcmp(bytes.data(), kFilmSignature.data(), kFilmSignature.size()) == 0;
}

}  // namespace

std::vector<std::byte> encode_film(const FilmFile& film) {
  const auto whole = [](auto value) { return static_cast<std::uint64_t>(value); };
  const Header header{film.setting.size(),
                      whole(film.width),
                      whole(film.height),
                      whole(film.channels),
                      film.scrambles.size(),
                      film.rounds.words().size(),
                      film.counts.size(),
                      bytes_of_sums(film),
                      std::bit_cast<std::uint64_t>(film.round_unit),
                      {0, 0}};
  std::vector<std::byte> out;
  out.reserve(file_bytes(header));
  put(out, kFilmSignature);
  for (const std::uint64_t word : std::bit_cast<HeaderWords>(header)) put(out, word);
  put(out, film.setting);
  for (const std::uint64_t word : film.rounds.words()) put(out, word);
  for (const std::int64_t count : film.counts) put(out, whole(count));
  for (const FilmFile::Scramble& one : film.scrambles) {
    put(out, one.lines);
    for (const std::int64_t sum : one.sums) put(out, whole(sum), header.sum_bytes);
  }
  put(out, Hash().add(out).value());
  return out;
}

Result<FilmFile> decode_film(std::span<const std::byte> bytes, const std::string& name) {
  const auto wrong = [&](std::string what, const char* hint = "write or copy it again") {
    return fail(named_place(name), std::move(what), hint);
  };
  if (!is_film(bytes))
    return wrong("is not a film of this version", "flatray render SCENE -o x.film writes one");
  if (bytes.size() < kFilmSignature.size() + sizeof(Header))
    return wrong("film ends in its header");
  Reader reader{bytes.subspan(kFilmSignature.size())};
  const Header header = read_header(reader);
  if (!in_range(header)) return wrong("film has a header that no film has");
  if (bytes.size() != file_bytes(header))
    return wrong(fmt::format("film has {} bytes, and its header tells of {}", bytes.size(),
                             file_bytes(header)));
  Reader end{bytes.last(8)};
  if (Hash().add(bytes.first(bytes.size() - 8)).value() != end.number())
    return wrong("film is damaged: its checksum is another");
  FilmFile film{std::string(reader.text(header.setting)), static_cast<int>(header.width),
                static_cast<int>(header.height), static_cast<int>(header.channels),
                std::bit_cast<double>(header.unit)};
  if (!(film.round_unit >= 0 && std::isfinite(film.round_unit)))
    return wrong("film has light without a unit");
  std::vector<std::uint64_t> words;
  for (std::uint64_t i = 0; i < header.words; ++i) words.push_back(reader.number());
  if (!words.empty() && words.back() == 0) return wrong("film has rounds that are none");
  film.rounds = FilmRounds(std::move(words));
  for (std::uint64_t i = 0; i < header.counts; ++i)
    film.counts.push_back(static_cast<std::int64_t>(reader.number()));
  for (std::uint64_t i = 0; i < header.scrambles; ++i)
    if (!read_scramble(reader, header, film.scrambles.emplace_back()) ||
        lines_of(film) > LightFilm::kMostLines)
      return wrong("film has more light than its lines can have");
  if (bytes_of_sums(film) != header.sum_bytes) return wrong("film has sums of needless bytes");
  return film;
}

Result<void> add_film(FilmFile& film, const FilmFile& more, const std::string& name) {
  const auto wrong = [&](std::string what, const char* hint) {
    return fail(named_place(name), std::move(what), hint);
  };
  if (more.setting != film.setting || more.width != film.width || more.height != film.height ||
      more.channels != film.channels || more.scrambles.size() != film.scrambles.size() ||
      more.counts.size() != film.counts.size() ||
      std::bit_cast<std::uint64_t>(more.round_unit) !=
          std::bit_cast<std::uint64_t>(film.round_unit))
    return wrong("is a film of other light", "add films of one scene, size and seed");
  if (film.rounds.meets(more.rounds))
    return wrong("has rays that are in the films before, too", "add each shard once");
  if (lines_of(film) > LightFilm::kMostLines - lines_of(more))
    return wrong("is more than one film holds", "add fewer films");
  std::vector<std::int64_t> counts = film.counts;
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (__builtin_add_overflow(counts[i], more.counts[i], &counts[i]))
      return wrong("is more than one film holds", "add fewer films");
  film.counts = std::move(counts);
  film.rounds.add(more.rounds);
  for (std::size_t k = 0; k < film.scrambles.size(); ++k) {
    FilmFile::Scramble& scramble = film.scrambles[k];
    scramble.lines += more.scrambles[k].lines;
    for (std::size_t i = 0; i < scramble.sums.size(); ++i)
      scramble.sums[i] += more.scrambles[k].sums[i];
  }
  return {};
}

}  // namespace flatray
