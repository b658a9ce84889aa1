// Films whose checksums are right and whose numbers no rays have.
#include "app/frames/light_files.h"

#include <gtest/gtest.h>

#include "base/file.h"
#include "support/own_folder.h"

namespace flatray {
namespace {

// The light of four rays of one round in one pixel, and of that what a test wants otherwise.
FilmFile film_of_four() {
  FilmFile film;
  film.setting = R"({"size":"1x1","scrambles":1,"exposure":2.5,"tone":"soft","gamma":2.2})";
  film.width = film.height = film.channels = 1;
  film.round_unit = 0.25;
  film.rounds.add(7);
  film.counts = {4, 6, 12 << 20, 5 << 20, 8 << 20, 0, 0, -(1 << 20)};
  film.scrambles = {{6, {100}}};
  return film;
}

class ForgedFilm : public OwnFolder {
 protected:
  std::string refusal_of(const FilmFile& film) const {
    const auto path = folder_ / "x.film";
    EXPECT_TRUE(write_file(path, encode_film(film)));
    const auto read = read_film(path, 1 << 20);
    return read ? "" : read.error().front().message;
  }
  std::string refusal_of(void (*forge)(FilmFile&)) const {
    FilmFile film = film_of_four();
    forge(film);
    return refusal_of(film);
  }
};

TEST_F(ForgedFilm, IsReadWhereItsNumbersFit) { EXPECT_EQ(refusal_of(film_of_four()), ""); }

TEST_F(ForgedFilm, IsToldByWhatDoesNotFit) {
  struct Case {
    void (*forge)(FilmFile&);
    const char* what;
  };
  constexpr Case kCases[] = {
      {[](FilmFile& film) { film.counts.pop_back(); }, "7 counts"},
      {[](FilmFile& film) { film.counts[3] += 1; }, "is not what was emitted"},
      {[](FilmFile& film) { film.counts[3] -= 6 << 20, film.counts[4] += 6 << 20; },
       "it counts -1048576 of light"},
      {[](FilmFile& film) { film.counts[2] += 13 << 20, film.counts[4] += 13 << 20; },
       "4 rays cannot emit so much light"},
      {[](FilmFile& film) { film.rounds.add(8), film.rounds.add(9); }, "4 rays are no 3 rounds"},
      {[](FilmFile& film) { film.rounds = {}; }, "4 rays are no 0 rounds"},
      {[](FilmFile& film) { film.counts[1] = 0; }, "6 lines of light do not come from 0 legs"},
      {[](FilmFile& film) {
         film.scrambles.push_back({0, {0}});
       },
       "2 scrambles"},
      {[](FilmFile& film) { film.setting = "{"; }, "is no JSON"},
      {[](FilmFile& film) { film.setting = R"({"size":"2x1","scrambles":1})"; },
       "is not of 1x1 pixels and 1 scramble"},
      {[](FilmFile& film) { film.setting.replace(film.setting.find("2.5"), 3, "-25"); },
       "its exposure"},
      {[](FilmFile& film) { film.setting.replace(film.setting.find("2.2"), 3, "220"); },
       "its gamma"},
      {[](FilmFile& film) { film.setting.replace(film.setting.find("soft"), 4, "hard"); },
       "its tone"}};
  for (const auto& [forge, what] : kCases) {
    const std::string told = refusal_of(forge);
    EXPECT_NE(told.find("is not a film that flatray render writes: "), std::string::npos) << what;
    EXPECT_NE(told.find(what), std::string::npos) << told;
  }
}

}  // namespace
}  // namespace flatray
