#include <gtest/gtest.h>

#include <limits>

#include "base/hash.h"
#include "image/light_lines.h"

// That the sums of a film have no order, and the room that they and the lines take.
namespace flatray {
namespace {

using namespace light_lines;

TEST(LightFilm, HasNoOrderNoBatchesAndNoThreads) {
  for (const int channels : {1, 3}) {
    const Lines lines = lines_of_all_kinds(20000, 700, 300, 8);
    const Sums sums = sums_of(700, 300, lines, channels);
    for (const unsigned threads : {2U, 3U, 7U, 64U})
      EXPECT_EQ(sums_of(700, 300, lines, channels, threads), sums) << threads;
    Lines shuffled;
    for (std::size_t i = 0; i < lines.size(); ++i)
      shuffled.push_back(lines[i * 7919 % lines.size()]);
    EXPECT_EQ(sums_of(700, 300, shuffled, channels, 2), sums);
    LightFilm film(700, 300, channels);
    for (std::size_t begin = 0, size = 1; begin < lines.size(); begin += size, size *= 3)
      film.add(std::span(lines).subspan(begin, std::min(size, lines.size() - begin)), 1 + size % 4);
    EXPECT_EQ(film.sums(), sums);
  }
}

TEST(LightFilm, HasChannelsThatAreFilmsOfTheirOwn) {
  Lines lines = lines_of_all_kinds(3000, 300, 200, 11);
  const Sums all = sums_of(300, 200, lines, 3);
  for (std::size_t c = 0; c < 3; ++c) {
    for (LightLine& line : lines) std::swap(line.weight[0], line.weight[c]);
    const Sums one = sums_of(300, 200, lines);
    for (LightLine& line : lines) std::swap(line.weight[0], line.weight[c]);
    for (std::size_t i = 0; i < one.size(); ++i) ASSERT_EQ(all[3 * i + c], one[i]) << i << ' ' << c;
  }
}

TEST(LightFilm, IsTheSameInEveryTier) {
  const Lines lines = lines_of_all_kinds(20000, 700, 300, 9);
  for (const int channels : {1, 3}) {
    const Sums sums = sums_of(700, 300, lines, channels, 1, Isa::portable);
    EXPECT_GT(total_of(sums), 1e6);
    for (const Isa isa : available_isas())
      EXPECT_EQ(sums_of(700, 300, lines, channels, 1, isa), sums) << isa_name(isa);
  }
}

// The same of g++ and clang++, optimised or not.
TEST(LightFilm, IsTheSameOfEveryCompiler) {
  Hash hash;
  const Sums sums = sums_of(700, 300, lines_of_all_kinds(2000, 700, 300, 13), 3);
  hash.add(std::as_bytes(std::span(sums)));
  EXPECT_EQ(hash.hex(), "4c109c410723a6f4");
}

TEST(LightFilm, MergesTheFilmsOfPartsToThatOfAll) {
  const Lines lines = lines_of_all_kinds(9000, 300, 200, 10);
  LightFilm all(300, 200, 3), first(300, 200, 3), last(300, 200, 3), copied(300, 200, 3);
  all.add(lines);
  first.add(std::span(lines).first(4000));
  last.add(std::span(lines).subspan(4000));
  copied.add_sums(last.sums(), last.lines());
  last.merge(first);
  EXPECT_EQ(last.sums(), all.sums());
  EXPECT_EQ(last.lines(), 9000U);
  copied.add(std::span(lines).first(4000));
  EXPECT_EQ(copied.sums(), all.sums());
}

// Every part of a line, whatever the room; as lengths along the major axis, whole numbers of 2^-16.
TEST(LightFilm, CutsAsManyLinesAsThereIsRoomFor) {
  const Lines lines = lines_of_all_kinds(20000, 300, 200, 12);
  const auto cut = [&](std::size_t room) {
    LightBins bins(300, 200, room);
    double length = 0;
    std::size_t rounds = 0;
    for (std::span<const LightLine> left = lines; !left.empty(); ++rounds) {
      bins.clear();
      left = left.subspan(bins.cut(left));
      for (std::size_t bin = 0; bin < 6 * LightBins::kBinsOfTile; ++bin)
        bins.pieces(bin, [&](std::span<const kernels::LightPiece> pieces) {
          for (const kernels::LightPiece& piece : pieces)
            length += std::round(static_cast<double>(piece.to - piece.from) * kUnits);
        });
    }
    return std::pair(length, rounds);
  };
  EXPECT_EQ(cut(1 << 16).second, 1U);
  EXPECT_GT(cut(0).second, 5U);
  EXPECT_EQ(cut(0).first, cut(1 << 16).first);
}

// The most that a line can add to a pixel, more often than 32 bits hold, and more lines than are cut
// at once.
TEST(LightFilm, SumsPast32Bits) {
  constexpr std::size_t kTimes = 1'200'000;
  const Lines lines(kTimes, white(0, 0, 3, 3)), upright(50'000, white(0.5, 0, 0.5 + 0x1p-60, 3));
  for (const Isa isa : available_isas()) {
    LightFilm film(3, 3, 1, isa);
    const Sums one = sums_of(3, 3, {lines[0]});
    film.add(lines);
    film.add(upright);
    Sums expected(9);
    for (std::size_t i : {0U, 4U, 8U}) expected[i] = one[i] * static_cast<std::int64_t>(kTimes);
    for (std::size_t i : {0U, 3U, 6U}) expected[i] += std::int64_t{50'000} * 65536;
    EXPECT_GT(expected[0], std::int64_t{1} << 36);
    EXPECT_EQ(film.sums(), expected) << isa_name(isa);
  }
}

TEST(LightFilm, KnowsItsMemory) {
  EXPECT_GE(LightFilm::bytes(1920, 1080, 3, 1), 135ULL * 128 * 128 * 3 * 16);
  EXPECT_LE(LightFilm::bytes(1920, 1080, 3, 2), 160'000'000U);
  EXPECT_LE(LightFilm::bytes(1920, 1080, 1, 2), 80'000'000U);
}

TEST(LightFilmDeathTest, RefusesWhatIsNoLine) {
  LightFilm film(4, 4, 1), other(4, 5, 1);
  const double none = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  EXPECT_DEATH(film.add(Lines{white(none, 0, 1, 1)}), "in_range");
  EXPECT_DEATH(film.add(Lines{white(0, 0, 1, infinite)}), "in_range");
  EXPECT_DEATH(film.add(Lines{{0, 0, 1, 1, {1.5F, 0, 0}}}), "in_range");
  EXPECT_DEATH(film.add(Lines{{0, 0, 1, 1, {std::nanf(""), 0, 0}}}), "in_range");
  EXPECT_DEATH(film.merge(other), "height");
  EXPECT_DEATH(film.add_sums(Sums(16, 1 << 18), 2), "lines");
  film.add_sums(Sums(16), LightFilm::kMostLines);
  EXPECT_DEATH(film.add(Lines{white(0, 0, 1, 1)}), "kMostLines");
}

}  // namespace
}  // namespace flatray
