// needs: gl shapes/circle shapes/convex shapes/import shapes/polygon shapes/segment formats/obj
#include <gtest/gtest.h>

#include "app/golden/golden_check.h"
#include "support/paths.h"

namespace flatray {
namespace {

class GlGoldens : public testing::Test {
 protected:
  void SetUp() override {
    const auto rows = read_goldens(source_path());
    ASSERT_TRUE(rows) << format(rows.error());
    for (const GoldenRow& row : *rows)
      if (!row.exact()) rows_.push_back(row);
    ASSERT_GE(rows_.size(), 2U);
  }
  std::vector<GoldenRow> rows_;
};

TEST_F(GlGoldens, AreDrawnAgainWithinTheirTolerance) {
  for (const GoldenRow& row : rows_) {
    const auto check = check_golden(source_path(), row);
    ASSERT_TRUE(check) << format(check.error());
    EXPECT_TRUE(check->passes()) << golden_report(row, *check);
  }
}

TEST_F(GlGoldens, NameTheVersionOfMesa) {
  for (const GoldenRow& row : rows_)
    EXPECT_NE(row.renderer.find("Mesa "), std::string::npos) << row.file();
}

TEST_F(GlGoldens, AFailureNamesTheWorstPixelAndBothRenderers) {
  const GoldenRow& row = rows_.front();
  auto check = check_golden(source_path(), row);
  ASSERT_TRUE(check) << format(check.error());
  std::uint8_t& level = check->actual.at(3, 2)[1];
  level = static_cast<std::uint8_t>(level < 128 ? level + 100 : level - 100);
  check->difference = compare(check->actual, check->expected).value();
  check->renderer = "gl: another Mesa";
  EXPECT_FALSE(check->passes());
  const std::string report = golden_report(row, *check);
  for (const std::string& part :
       {std::string("worst pixel (3, 2) green"), row.tolerance.text() + " allowed",
        "accepted from " + row.renderer, std::string("drawn by gl: another Mesa"),
        std::string("--backend gl")})
    EXPECT_NE(report.find(part), std::string::npos) << part << "\n" << report;
}

TEST(Tolerance, ReadsBackAsItsText) {
  const Tolerance some{3, 120};
  EXPECT_EQ(Tolerance::parse(some.text()).value().text(), "max=3;pixels=120");
  for (const char* wrong : {"", "max=1", "max=256;pixels=1", "max=1;pixels=", "max=-1;pixels=0",
                            "max=1;pixels=2;", "pixels=1;max=0"})
    EXPECT_FALSE(Tolerance::parse(wrong)) << wrong;
  Difference difference;
  difference.worst = 3, difference.pixels = 120;
  EXPECT_TRUE(some.allows(difference));
  difference.pixels = 121;
  EXPECT_FALSE(some.allows(difference));
  difference.worst = 4, difference.pixels = 1;
  EXPECT_FALSE(some.allows(difference));
}

}  // namespace
}  // namespace flatray
