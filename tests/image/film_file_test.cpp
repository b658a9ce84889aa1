#include "image/film_file.h"

#include <gtest/gtest.h>

#include <limits>

#include "base/hash.h"
#include "image/light_film.h"

namespace flatray {
namespace {

using FilmBytes = std::vector<std::byte>;

// Of 3 x 2 pixels, two scrambles, one round.
FilmFile film_with(std::uint64_t round, std::int64_t light) {
  FilmFile film{"{\"seed\":1}", 3, 2, 3, 0.25, {}, {light, -7}, {}};
  film.rounds.add(round);
  for (std::int64_t k = 0; k < 2; ++k) {
    film.scrambles.push_back({4, std::vector<std::int64_t>(18, 0)});
    film.scrambles.back().sums[5] = light + k;
  }
  return film;
}

FilmFile sum_of(const std::vector<FilmFile>& films) {
  FilmFile all = films.front();
  for (std::size_t i = 1; i < films.size(); ++i)
    EXPECT_TRUE(add_film(all, films[i], "more.film").has_value());
  return all;
}

// With the checksum of what it is now.
FilmBytes signed_again(FilmBytes bytes) {
  const std::uint64_t sum = Hash().add(std::span(bytes).first(bytes.size() - 8)).value();
  for (std::size_t i = 0; i < 8; ++i)
    bytes[bytes.size() - 8 + i] = static_cast<std::byte>(sum >> (8 * i));
  return bytes;
}

void put(FilmBytes& bytes, std::size_t at, std::uint64_t value) {
  for (std::size_t i = 0; i < 8; ++i) bytes[at + i] = static_cast<std::byte>(value >> (8 * i));
}

std::string refusal_of(const FilmBytes& bytes) {
  const auto film = decode_film(bytes, "x.film");
  return film ? "none" : format(film.error());
}

TEST(FilmFiles, AreReadAsTheyWereWritten) {
  for (const std::int64_t light : {1L, 200L, 70000L, (4L << 17) - 2}) {
    const FilmFile film = film_with(77, light);
    const auto read = decode_film(encode_film(film), "x.film");
    ASSERT_TRUE(read.has_value()) << format(read.error());
    EXPECT_EQ(*read, film);
  }
}

TEST(FilmFiles, TakeAsManyBytesASumAsTheLargestNeeds) {
  const std::size_t one = encode_film(film_with(0, 254)).size();
  EXPECT_EQ(encode_film(film_with(0, 255)).size(), one + 36);
}

TEST(FilmFiles, AddUpToOneFilmInAnyOrder) {
  const FilmFile a = film_with(0, 5), b = film_with(64, 300), c = film_with(3, 70);
  const FilmBytes all = encode_film(sum_of({a, b, c}));
  EXPECT_EQ(encode_film(sum_of({c, a, b})), all);
  EXPECT_EQ(encode_film(sum_of({b, sum_of({c, a})})), all);
  EXPECT_EQ(sum_of({a, b, c}).rounds.count(), 3U);
  EXPECT_EQ(sum_of({a, b, c}).scrambles[1].sums[5], 378);
}

TEST(FilmFiles, OfOtherLightOrOfRoundsThatAreThereAreNotAdded) {
  FilmFile film = film_with(0, 5);
  const FilmFile before = film;
  FilmFile other = film_with(1, 5);
  EXPECT_FALSE(add_film(film, film_with(0, 9), "more.film"));
  other.setting = "{\"seed\":2}";
  EXPECT_FALSE(add_film(film, other, "more.film"));
  other = film_with(1, 5);
  other.round_unit = 0.5;
  EXPECT_FALSE(add_film(film, other, "more.film"));
  other = film_with(1, 5);
  other.scrambles.pop_back();
  EXPECT_FALSE(add_film(film, other, "more.film"));
  other = film_with(1, 5);
  other.scrambles[0].lines = LightFilm::kMostLines - 4;  // and four more of the other scramble
  EXPECT_FALSE(add_film(film, other, "more.film"));
  other = film_with(1, 5);
  film.counts[1] = std::numeric_limits<std::int64_t>::min();
  EXPECT_FALSE(add_film(film, other, "more.film"));
  film.counts[1] = before.counts[1];
  EXPECT_EQ(film, before);
}

TEST(FilmFiles, ThatAreDamagedAreRefusedAtEveryByte) {
  const FilmBytes bytes = encode_film(film_with(9, 1234));
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    FilmBytes damaged = bytes;
    damaged[i] ^= std::byte{4};
    EXPECT_NE(refusal_of(damaged).find("x.film: error:"), std::string::npos) << i;
  }
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_NE(refusal_of(FilmBytes(bytes.begin(), bytes.begin() + static_cast<long>(size))), "none")
        << size;
  FilmBytes longer = bytes;
  longer.push_back(std::byte{0});
  EXPECT_NE(refusal_of(signed_again(longer)), "none");
}

// Whoever writes a checksum can write a header: nothing is allocated for what is not there.
TEST(FilmFiles, WithHostileHeadersAreRefused) {
  const FilmBytes bytes = encode_film(film_with(0, 1234));
  const std::size_t header = kFilmSignature.size();
  for (std::size_t word = 0; word < 11; ++word)
    for (const std::uint64_t value :
         {std::uint64_t{0}, std::uint64_t{2}, std::uint64_t{64}, std::uint64_t{65536},
          std::uint64_t{1} << 40, ~std::uint64_t{0}}) {
      FilmBytes hostile = bytes;
      put(hostile, header + 8 * word, value);
      if (hostile == bytes || word == 8) continue;  // any number that is not negative is a unit
      EXPECT_NE(refusal_of(signed_again(hostile)), "none") << word << " " << value;
    }
  FilmBytes negative = bytes;
  put(negative, header + 64, std::uint64_t{1} << 63 | 1);
  EXPECT_NE(refusal_of(signed_again(negative)).find("without a unit"), std::string::npos);
}

TEST(FilmFiles, WithAnEndlessUnitAreRefused) {
  FilmFile film = film_with(0, 1);
  film.round_unit = std::numeric_limits<double>::infinity();
  EXPECT_NE(refusal_of(encode_film(film)).find("without a unit"), std::string::npos);
}

TEST(FilmFiles, WithMoreLightThanLinesAreRefused) {
  FilmFile film = film_with(0, 1234);
  film.scrambles[1].sums[5] = 4 << 17;  // of its four lines
  EXPECT_NE(refusal_of(encode_film(film)).find("more light than"), std::string::npos);
  film.scrambles[1].sums[5] = 0;
  film.scrambles[1].lines = LightFilm::kMostLines;
  EXPECT_NE(refusal_of(encode_film(film)).find("more light than"), std::string::npos);
}

}  // namespace
}  // namespace flatray
