#include "image/light_film.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "full_counts.h"
#include "image/light_lines.h"

namespace flatray {
namespace {

using namespace light_lines;

// The length of a line in a pixel by exact clipping; of one along a border, all to the pixel after.
double exact_length(const LightLine& line, int column, int row) {
  mpq_class enter = 0, leave = 1;
  const auto clip = [&](double from, double to, int low) {
    const mpq_class a(from), d = mpq_class(to) - a;
    if (d == 0) return a >= low && a < low + 1;
    mpq_class t0 = (low - a) / d, t1 = (low + 1 - a) / d;
    if (t0 > t1) swap(t0, t1);
    if (t0 > enter) enter = t0;
    if (t1 < leave) leave = t1;
    return enter < leave;
  };
  if (!clip(line.from_x, line.to_x, column) || !clip(line.from_y, line.to_y, row)) return 0;
  const mpq_class part = leave - enter, dx = part * (mpq_class(line.to_x) - mpq_class(line.from_x)),
                  dy = part * (mpq_class(line.to_y) - mpq_class(line.from_y));
  const mpq_class square = dx * dx + dy * dy;
  return std::sqrt(square.get_d());
}

double slope_of(const LightLine& line) {
  const double dx = std::fabs(line.to_x - line.from_x), dy = std::fabs(line.to_y - line.from_y);
  return std::min(dx, dy) / std::max(dx, dy);
}

double largest_coordinate(const LightLine& line) {
  return std::max(
      {std::fabs(line.from_x), std::fabs(line.from_y), std::fabs(line.to_x), std::fabs(line.to_y)});
}

// What LightFilm promises of a pixel: the length of a line moved by less than 2^-15, and 2 units.
double pixel_bound(const LightLine& line) {
  const double moved = 0x1p-15 + 0x1p-50 * largest_coordinate(line), slope = slope_of(line);
  return std::min(std::numbers::sqrt2, 3 * moved / slope) + 2 / kUnits;
}

void expect_near_exact(const LightLine& line, int width, int height) {
  const Sums sums = sums_of(width, height, {line});
  double exact = 0;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      const double length = exact_length(line, column, row) * static_cast<double>(line.weight[0]);
      exact += length;
      const double sum =
          static_cast<double>(sums[static_cast<std::size_t>(row * width + column)]) / kUnits;
      ASSERT_NEAR(sum, length, pixel_bound(line))
          << column << ',' << row << " of " << line.from_x << ',' << line.from_y << " to "
          << line.to_x << ',' << line.to_y;
    }
  ASSERT_NEAR(total_of(sums), exact,
              0x1p-23 * exact + 4 / kUnits + 0x1p-49 * largest_coordinate(line));
}

TEST(LightFilm, CountsTheLengthInEachPixel) {
  const Sums row = sums_of(4, 2, {white(0, 0.5, 4, 0.5)});
  EXPECT_EQ(row, (Sums{65536, 65536, 65536, 65536, 0, 0, 0, 0}));
  const Sums column = sums_of(2, 3, {white(1.25, 2.5, 1.25, 0.25)});
  EXPECT_EQ(column, (Sums{0, 49152, 0, 65536, 0, 32768}));
  // A slope of 3 / 4: 5 for 4 across, and 5 / 3 for every row; columns round their totals.
  const Sums slanted = sums_of(4, 3, {white(0, 0, 4, 3)});
  EXPECT_EQ(slanted, (Sums{81920, 27307, 0, 0, 0, 54613, 54613, 0, 0, 0, 27307, 81920}));
  const Sums coloured = sums_of(1, 1, {{0, 0.5, 1, 0.5, {1, 0.5F, 0.25F}}}, 3);
  EXPECT_EQ(coloured, (Sums{65536, 32768, 16384}));
}

TEST(LightFilm, GivesALineOnABorderToThePixelRightOrBelow) {
  EXPECT_EQ(sums_of(3, 1, {white(1, 0, 1, 1)}), (Sums{0, 65536, 0}));
  EXPECT_EQ(sums_of(1, 3, {white(1, 1, 0, 1)}), (Sums{0, 65536, 0}));
  EXPECT_EQ(sums_of(2, 2, {white(0, 0, 2, 0), white(0, 2, 2, 2)}), (Sums{65536, 65536, 0, 0}));
  EXPECT_EQ(sums_of(2, 2, {white(0, 0, 0, 2), white(2, 0, 2, 2)}), (Sums{65536, 0, 65536, 0}));
  // At the border of two tiles, too.
  const Sums across = sums_of(200, 1, {white(128, 0, 128, 1), white(127, 1, 127, 0)});
  EXPECT_EQ(across[127], 65536);
  EXPECT_EQ(across[128], 65536);
  EXPECT_EQ(total_of(across), 2);
}

TEST(LightFilm, AddsNothingOfAPointOrALineOutside) {
  constexpr double kTiny = std::numeric_limits<double>::denorm_min();
  const Lines lines = {white(1, 1, 1, 1),
                       white(kTiny, kTiny, kTiny, kTiny),
                       white(0, 0, kTiny, kTiny),
                       white(-1, -1, -1, 5),
                       white(5, 5, 9, 9),
                       white(-3, 2, 2, -3),
                       white(0, -1e-300, 9, -1e-300),
                       white(4, 0, 4, 4)};
  for (const LightLine& line : lines) EXPECT_EQ(total_of(sums_of(4, 4, {line})), 0);
}

TEST(LightFilm, IsWithinItsBoundOfExactClipping) {
  for (const LightLine& line : lines_of_all_kinds(times(300), 40, 30, 1))
    expect_near_exact(line, 40, 30);
}

TEST(LightFilm, IsWithinItsBoundAcrossTiles) {
  for (LightLine line : lines_of_all_kinds(times(60), 4, 140, 2)) {
    line.to_x = std::clamp(line.to_x, -2.0, 6.0), line.from_x = std::clamp(line.from_x, -2.0, 6.0);
    expect_near_exact(line, 4, 140);
    std::swap(line.from_x, line.from_y), std::swap(line.to_x, line.to_y);
    expect_near_exact(line, 140, 4);
  }
}

// Both ends far outside: where the line is, is known to the last digits of its ends.
TEST(LightFilm, CutsLinesThatComeFromFarAndGoFar) {
  Draws draws(3);
  for (std::uint64_t i = 0; i < times(150); ++i) {
    const double x = draws.between(1, 9), y = draws.between(1, 7), turn = draws.between(0, 7);
    const double back = std::exp2(draws.between(0, 36)), on = std::exp2(draws.between(0, 36));
    expect_near_exact(white(x - back * std::cos(turn), y - back * std::sin(turn),
                            x + on * std::cos(turn), y + on * std::sin(turn)),
                      10, 8);
  }
}

TEST(LightFilm, TakesTheLargestDoubles) {
  constexpr double kMost = std::numeric_limits<double>::max();
  EXPECT_EQ(sums_of(3, 1, {white(-kMost, 0.5, kMost, 0.5)}), (Sums{65536, 65536, 65536}));
  EXPECT_EQ(sums_of(1, 3, {white(0.5, 1e300, 0.5, 1.5)}), (Sums{0, 32768, 65536}));
  const Sums diagonal = sums_of(2, 2, {white(-kMost, -kMost, kMost, kMost)});
  EXPECT_EQ(diagonal, sums_of(2, 2, {white(0, 0, 2, 2)}));
  EXPECT_EQ(sums_of(9, 9, {white(2, 3, 2 + 1e300, 3 + 5e299)}),
            sums_of(9, 9, {white(2, 3, 12, 8)}));
  // Of these no digit is left on the film; they are drawn somewhere, and no more than a line can be.
  Draws draws(4);
  const auto huge = [&] { return draws.between(-1, 1) * std::exp2(draws.between(0, 1023)); };
  for (std::uint64_t i = 0; i < times(200); ++i) {
    const double total = total_of(sums_of(300, 200, {white(huge(), huge(), huge(), huge())}));
    EXPECT_GE(total, 0);
    EXPECT_LE(total, 361);
  }
}

TEST(LightFilm, HoldsTheLengthOfAllLinesTogether) {
  constexpr int kWidth = 700, kHeight = 430;
  Draws draws(5);
  Lines lines;
  long double exact = 0;
  for (int i = 0; i < 3000; ++i) {
    lines.push_back(white(draws.between(0, kWidth), draws.between(0, kHeight),
                          draws.between(0, kWidth), draws.between(0, kHeight)));
    const LightLine& line = lines.back();
    exact += std::sqrt(std::pow(static_cast<long double>(line.to_x - line.from_x), 2) +
                       std::pow(static_cast<long double>(line.to_y - line.from_y), 2));
  }
  const double off = total_of(sums_of(kWidth, kHeight, lines)) / static_cast<double>(exact) - 1;
  EXPECT_LT(std::fabs(off), 1e-7);
  // Weak lines are rounded no worse: a column's share is what its total adds to that before it.
  for (LightLine& line : lines) line.weight[0] = 0x1p-12F;
  const double weak =
      total_of(sums_of(kWidth, kHeight, lines)) * 0x1p12 / static_cast<double>(exact) - 1;
  EXPECT_LT(std::fabs(weak), 1e-5);
}

// A line that lies nearer to the last border of the film than floats tell is still on it.
TEST(LightFilm, LosesNothingAtItsLastRowAndColumn) {
  for (const int size : {1, 2, 3, 127, 128, 129, 130, 257}) {
    const double end = std::nextafter(size, 0), length = size;
    EXPECT_EQ(total_of(sums_of(size, size, {white(0, end, length, end)})), length);
    EXPECT_EQ(total_of(sums_of(size, size, {white(end, length, end, 0)})), length);
    EXPECT_EQ(total_of(sums_of(size, size, {white(0, 0, length, 0)})), length);
    EXPECT_EQ(sums_of(size, size, {white(0, end, length, end)}).back(), 65536);
  }
}

TEST(LightFilm, IsTheSameForALineAndItsReverse) {
  Lines lines = lines_of_all_kinds(2000, 300, 200, 6);
  const Sums there = sums_of(300, 200, lines, 3);
  for (LightLine& line : lines)
    std::swap(line.from_x, line.to_x), std::swap(line.from_y, line.to_y);
  EXPECT_EQ(sums_of(300, 200, lines, 3), there);
}

TEST(LightFilm, IsTurnedOverWithItsLines) {
  constexpr int kWidth = 300, kHeight = 200;
  Draws draws(7);
  const auto dyadic = [&](int size) {
    return std::floor(draws.between(-9, size + 9) * 1024) / 1024 + 0x1p-12;
  };
  Lines lines, turned;
  for (int i = 0; i < 2000; ++i) {
    const LightLine line = white(dyadic(kWidth), dyadic(kHeight), dyadic(kWidth), dyadic(kHeight));
    lines.push_back(line);
    turned.push_back(white(line.from_y, line.from_x, line.to_y, line.to_x));
  }
  const Sums sums = sums_of(kWidth, kHeight, lines), over = sums_of(kHeight, kWidth, turned);
  for (std::size_t row = 0; row < kHeight; ++row)
    for (std::size_t column = 0; column < kWidth; ++column)
      ASSERT_EQ(sums[row * kWidth + column], over[column * kHeight + row]);
}

// The light of a point is 1 / (2 pi r), whatever pixel it falls on.
TEST(LightFilm, OfAPointIsOneOverTheWayRound) {
  constexpr int kSize = 256, kRays = 1 << 18;
  constexpr double kX = 120.3, kY = 130.7;
  Lines lines;
  for (int i = 0; i < kRays; ++i) {
    const double turn = 2 * std::numbers::pi * (i + 0.5) / kRays;
    lines.push_back(white(kX, kY, kX + 400 * std::cos(turn), kY + 400 * std::sin(turn)));
  }
  const Sums sums = sums_of(kSize, kSize, lines, 1, 2);
  double squares = 0, mean = 0;
  int pixels = 0;
  for (int row = 0; row < kSize; ++row)
    for (int column = 0; column < kSize; ++column) {
      const double dx = column + 0.5 - kX, dy = row + 0.5 - kY;
      if (dx * dx + dy * dy < 16) continue;
      double light = 0;
      constexpr int kParts = 8;
      for (int i = 0; i < kParts * kParts; ++i) {
        const double x = column + (i % kParts + 0.5) / kParts - kX;
        const double y = row + (std::floor(static_cast<double>(i) / kParts) + 0.5) / kParts - kY;
        light += kRays / (2 * std::numbers::pi * std::sqrt(x * x + y * y)) / (kParts * kParts);
      }
      const double off = static_cast<double>(sums[static_cast<std::size_t>(row * kSize + column)]) /
                             kUnits / light -
                         1;
      squares += off * off, mean += off, ++pixels;
    }
  EXPECT_LT(std::sqrt(squares / pixels), 2e-3);
  EXPECT_LT(std::fabs(mean / pixels), 2e-5);
}

}  // namespace
}  // namespace flatray
