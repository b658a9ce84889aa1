#include "app/options/option_values.h"

#include <gtest/gtest.h>

namespace flatray {
namespace {

constexpr std::uint64_t kLimit = std::uint64_t{1} << 28;

std::string refusal(const char* size) {
  const auto parsed = parse_size(size, named_place("--size"), kLimit);
  if (parsed) return "accepted";
  const Diagnostic& problem = parsed.error().front();
  return problem.trouble == Trouble::usage ? format(problem) : "wrong trouble";
}

TEST(OptionValues, SecondsMayNameTheirUnitOnce) {
  EXPECT_EQ(parse_seconds("60s"), 60);
  EXPECT_EQ(parse_seconds("1.5"), 1.5);
  for (const char* none : {"", "s", "60ss", "60 s", "60m"})
    EXPECT_FALSE(parse_seconds(none)) << none;
}

TEST(OptionValues, ATextIsSplitAtEveryOneOfACharacter) {
  using Pieces = std::vector<std::string_view>;
  EXPECT_EQ(split("a,b|c", ','), (Pieces{"a", "b|c"}));
  EXPECT_EQ(split("|a||", '|'), (Pieces{"", "a", "", ""}));
  EXPECT_EQ(split("", ' '), Pieces{""});
}

TEST(StiffCases, E3RefusedSizesNameFieldAndLimit) {
  EXPECT_EQ(refusal("0x5"), "--size: error: width 0 leaves no picture\n    say 1 or more\n");
  EXPECT_NE(refusal("5x0").find("height 0"), std::string::npos);
  EXPECT_NE(refusal("-1x5").find("width '-1' is not a whole number"), std::string::npos);
  EXPECT_NE(refusal("1e9x1e9").find("width '1e9'"), std::string::npos);
  EXPECT_NE(refusal("2147483648x1").find("at most 268435456 pixels"), std::string::npos);
  EXPECT_NE(refusal("1x4294967297").find("height 4294967297 is over the limit"), std::string::npos);
  EXPECT_NE(refusal("65536x65536").find("4294967296 pixels, over the limit of 268435456"),
            std::string::npos);
  EXPECT_NE(refusal("99999999999999999999x1").find("width 99999999999999999999 is over"),
            std::string::npos);
  for (const char* bad :
       {"", "x", "5", "5x", "x5", "5X5", "5x5x5", " 5x5", "5 x 5", "+5x5", "0x10x5"})
    EXPECT_NE(refusal(bad), "accepted") << bad;
}

TEST(StiffCases, E2LongThinAndLargestSizesAreAccepted) {
  for (const auto& [text, width, height] :
       {std::tuple("1x1", 1, 1), std::tuple("100000x1", 100000, 1),
        std::tuple("1x100000", 1, 100000), std::tuple("16384x16384", 16384, 16384),
        std::tuple("268435456x1", 268435456, 1)}) {
    const auto size = parse_size(text, {}, kLimit);
    ASSERT_TRUE(size) << text;
    EXPECT_EQ(size->width, width);
    EXPECT_EQ(size->height, height);
  }
  EXPECT_FALSE(parse_size("16384x16385", {}, kLimit));
}

TEST(OptionValues, ACropLiesInsideTheFilm) {
  const FilmSize film{40, 30};
  const auto crop = parse_crop("10,5,40,30", {}, film);
  ASSERT_TRUE(crop);
  EXPECT_EQ(crop->x, 10);
  EXPECT_EQ(crop->y, 5);
  EXPECT_EQ(crop->width, 30);
  EXPECT_EQ(crop->height, 25);
  for (const char* bad : {"", "1,2,3", "1,2,3,4,5", "5,0,5,1", "6,0,5,1", "0,0,41,1", "0,0,1,31",
                          "-1,0,5,5", "a,0,5,5", "0,0,4294967297,1"})
    EXPECT_FALSE(parse_crop(bad, {}, film)) << bad;
}

TEST(OptionValues, ARayIsFourNumbers) {
  const auto ray = parse_ray("-1,2.5,1e-3,-4", {});
  ASSERT_TRUE(ray);
  EXPECT_EQ(ray->origin, Vec2(-1, 2.5));
  EXPECT_EQ(ray->direction, Vec2(0.001, -4));
  for (const char* bad : {"", "1,2,3", "1,2,3,4,5", "1,2,3,x", "1,2,x,3,4", "nan,0,0,0",
                          "1,2,inf,0", "1,2,3,1e400", "1;2;3;4"})
    EXPECT_FALSE(parse_ray(bad, {})) << bad;
}

TEST(OptionValues, AnOverrideIsCutAtItsFirstEquals) {
  const auto override = parse_override("a.b=c=d", {});
  ASSERT_TRUE(override);
  EXPECT_EQ(override->key, "a.b");
  EXPECT_EQ(override->value, "c=d");
  EXPECT_EQ(parse_override("x=", {})->value, "");
  EXPECT_FALSE(parse_override("novalue", {}));
  EXPECT_FALSE(parse_override("=5", {}));
}

TEST(OptionValues, ATimeIsAboveZeroAndUpToItsLimit) {
  EXPECT_EQ(parse_time("1.5s", {}, 60).value(), 1.5);
  EXPECT_EQ(parse_time("60", {}, 60).value(), 60);
  for (const char* bad : {"0", "-1s", "x", "", "61s"}) EXPECT_FALSE(parse_time(bad, {}, 60)) << bad;
}

}  // namespace
}  // namespace flatray
