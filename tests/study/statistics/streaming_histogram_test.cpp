#include "study/statistics/streaming_histogram.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace flatray {
namespace {

TEST(StreamingHistogram, CountsByBinAndWhatLiesAbove) {
  StreamingHistogram counts(0, 2, 4);
  for (const double number : {0.0, 0.25, 0.5, 1.75, 2.0, 99.0}) counts.add(number);
  EXPECT_EQ(numbers_of(sums_of(counts)), (Numbers{2, 1, 0, 1, 2}));
  EXPECT_EQ(counts.above(), 2);
  const Table table = counts.table();
  ASSERT_EQ(table.rows.size(), 5U);
  EXPECT_EQ(csv_text(table).substr(0, 40), "from,to,count,density\n0,0.5,2,0.66666666");
}

// What has no end has no density: none in the table, NaN among numbers.
TEST(StreamingHistogram, AboveItsBinsThereIsNoDensity) {
  StreamingHistogram counts(0, 1, 2);
  for (const double number : {0.25, 7.0}) counts.add(number);
  ExperimentResult result;
  counts.add_files(result, "bins", "");
  ASSERT_EQ(result.files.size(), 2U);
  const std::string& content = result.files[1].content;
  double last = 0;
  std::memcpy(&last, content.data() + content.size() - sizeof last, sizeof last);
  EXPECT_TRUE(std::isnan(last)) << last;
  EXPECT_FALSE(counts.table().rows.back()[3].as_number());
}

TEST(StreamingHistogram, OfPartsIsThatOfTheWhole) {
  StreamingHistogram whole(0, 1, 8), parts(0, 1, 8);
  for (int part = 0; part < 3; ++part) {
    StreamingHistogram some(0, 1, 8);
    for (int i = 0; i < 100; ++i) {
      const double number = 0.0137 * i * (part + 1) - std::floor(0.0137 * i * (part + 1));
      some.add(number);
      whole.add(number);
    }
    add(sums_of(parts), numbers_of(sums_of(some)));
  }
  EXPECT_EQ(numbers_of(sums_of(parts)), numbers_of(sums_of(whole)));
}

// 3 and 5 where 4 each are even: 1/4 + 1/4.
TEST(StreamingHistogram, TellsHowFarFromEvenItIs) {
  StreamingHistogram counts(0, 2, 2);
  for (int i = 0; i < 8; ++i) counts.add(i < 3 ? 0.5 : 1.5);
  EXPECT_DOUBLE_EQ(counts.chi_squared_of_even(), 0.5);
}

}  // namespace
}  // namespace flatray
