// needs: shapes/circle shapes/convex shapes/import shapes/polygon shapes/segment formats/obj
#include "app/golden/golden.h"

#include <gtest/gtest.h>

#include "app/golden/golden_check.h"
#include "base/philox.h"
#include "image/png.h"
#include "support/paths.h"

namespace flatray {
namespace {

struct Committed {
  GoldenRow row;
  Image image;
};

// The goldens of this project. Without them nothing below would test anything.
class Goldens : public testing::Test {
 protected:
  void SetUp() override {
    const auto rows = read_goldens(source_path());
    ASSERT_TRUE(rows) << format(rows.error());
    ASSERT_GE(rows->size(), 2U);
    for (const GoldenRow& row : *rows) {
      rows_.push_back(row);
      Result<Image> image = read_png(source_path("/" + row.file()));
      ASSERT_TRUE(image) << format(image.error());
      EXPECT_EQ(pixel_hash(*image), row.pixels) << row.file();
      goldens_.push_back({row, std::move(*image)});
    }
  }
  std::vector<GoldenRow> rows_;
  std::vector<Committed> goldens_;
};

TEST_F(Goldens, AreDrawnAgainExactly) {
  for (const GoldenRow& row : rows_) {
    if (!row.exact()) continue;  // gl_golden_test.cpp
    const auto check = check_golden(source_path(), row);
    ASSERT_TRUE(check) << format(check.error());
    EXPECT_TRUE(check->passes()) << golden_report(row, *check);
  }
}

TEST_F(Goldens, EveryOneFailsAgainstEveryOther) {
  for (const Committed& a : goldens_)
    for (const Committed& b : goldens_)
      if (&a != &b) {
        EXPECT_FALSE(judge(a.image, b.image).passes()) << a.row.file() << ' ' << b.row.file();
      }
}

TEST_F(Goldens, OneLevelInOneChannelOfOnePixelIsDetected) {
  constexpr int kPlaces = 100;
  for (const auto& [row, image] : goldens_) {
    Image changed = image;
    for (std::uint32_t draw = 0; draw < kPlaces; ++draw) {
      const std::size_t place =
          random_bits(1, Stream::test, row.frame, 0, draw) % image.pixels.size();
      std::uint8_t& level = changed.pixels[place];
      const std::uint8_t before = level;
      level = static_cast<std::uint8_t>(before == 255 ? 254 : before + 1);
      EXPECT_FALSE(judge(changed, image).passes()) << row.file() << " byte " << place;
      level = before;
    }
    EXPECT_TRUE(judge(changed, image).passes());
  }
}

TEST_F(Goldens, BlankPicturesAreDetected) {
  for (const auto& [row, image] : goldens_) {
    Image blank = image;
    for (std::size_t i = 0; i < blank.pixels.size(); ++i)  // all of it as its first pixel
      blank.pixels[i] = image.pixels[i % static_cast<std::size_t>(image.channels)];
    EXPECT_FALSE(judge(blank, image).passes()) << row.file() << " shows nothing";
    for (const std::uint8_t level : {std::uint8_t{0}, std::uint8_t{255}}) {
      blank.pixels.assign(blank.pixels.size(), level);
      EXPECT_FALSE(judge(blank, image).passes()) << row.file();
    }
  }
}

TEST_F(Goldens, EveryFileHasItsRowAndAllStayWithinTheLimits) {
  EXPECT_EQ(stray_goldens(source_path(), rows_), std::vector<std::string>{});
  std::uintmax_t bytes = 0;
  for (const Committed& golden : goldens_) {  // no bindings: clang 14 cannot capture them
    const GoldenRow& row = golden.row;
    const Image& image = golden.image;
    bytes += std::filesystem::file_size(source_path("/" + row.file()));
    EXPECT_TRUE(image.width == row.width && image.height == row.height) << row.file();
    EXPECT_LE(
        std::count_if(rows_.begin(), rows_.end(),
                      [&](const GoldenRow& other) { return other.is_of(row.scene, row.backend); }),
        static_cast<std::ptrdiff_t>(kGoldenFrames))
        << row.scene;
  }
  EXPECT_LE(bytes, kGoldenBytes);
}

}  // namespace
}  // namespace flatray
