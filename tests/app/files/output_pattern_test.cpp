#include "app/files/output_pattern.h"

#include <gtest/gtest.h>

namespace flatray {
namespace {

std::string path(const char* pattern, unsigned frame, const char* scene = "demo") {
  const auto parsed = OutputPattern::parse(pattern, std::nullopt, {});
  return parsed ? parsed->path(scene, frame).string() : "refused";
}

bool refused(const std::string& pattern, const std::optional<std::string>& format = {}) {
  const auto parsed = OutputPattern::parse(pattern, format, {});
  return !parsed && parsed.error().front().trouble == Trouble::usage;
}

TEST(OutputPattern, HashesArePaddedAndGrow) {
  EXPECT_EQ(path("out/frame_####.png", 7), "out/frame_0007.png");
  EXPECT_EQ(path("####.png", 123456), "123456.png");
  EXPECT_EQ(path("#.png", 7), "7.png");
}

TEST(OutputPattern, PercentNumbersAreAccepted) {
  EXPECT_EQ(path("f%04d.png", 7), "f0007.png");
  EXPECT_EQ(path("f%d.png", 7), "f7.png");
  EXPECT_EQ(path("%099d.png", 7), std::string(98, '0') + "7.png");
}

TEST(OutputPattern, OnlyTheLastRunInTheFileNameIsThePlace) {
  EXPECT_EQ(path("c#/a#_###.png", 7), "c#/a#_007.png");
  EXPECT_EQ(path("c##/still.png", 7), "c##/still.png");
}

TEST(OutputPattern, SceneStandsAnywhere) {
  EXPECT_EQ(path("{scene}/{scene}_#.png", 2, "hall"), "hall/hall_2.png");
  EXPECT_EQ(path("{scene}.png", 2, "{scene}"),
            "{scene}.png");  // what it stands for is not read again
}

TEST(OutputPattern, OtherWordsInBracesAreRefused) {
  EXPECT_TRUE(refused("{scen}_#.png"));
  EXPECT_TRUE(refused("{scene}/{Scene}.png"));
  EXPECT_EQ(path("{a b}{x.png", 7), "{a b}{x.png");
}

TEST(StiffCases, E7NothingElseInANameIsAFormat) {
  EXPECT_EQ(path("%s%n%x.png", 7), "%s%n%x.png");
  EXPECT_EQ(path("%4d%%.png", 7), "%4d%%.png");
  EXPECT_EQ(path("{}{0}.png", 7), "{}{0}.png");
  EXPECT_EQ(path("%00000000000000000009d.png", 7), "%00000000000000000009d.png");
}

TEST(StiffCases, E7NamesThatAreNoFilesAreRefused) {
  EXPECT_TRUE(refused(""));
  EXPECT_TRUE(refused("out/"));
  EXPECT_TRUE(refused(fmt::format("{:x>300}.png", "")));
  EXPECT_TRUE(refused(fmt::format("{:x>100}%099d.png", "")));
  EXPECT_TRUE(refused(fmt::format("{:/>5000}x.png", "")));
}

// A manifest is JSON: it could not name them.
TEST(OutputPattern, FramesAreNamedInUtf8) {
  EXPECT_TRUE(refused("b\xff_####.png"));
  EXPECT_EQ(path("\xff/b\xc3\xbc_#.png", 7), "\xff/b\xc3\xbc_7.png");
  EXPECT_EQ(path("b\xff.png", 7), "b\xff.png");
}

TEST(OutputPattern, TheExtensionDecidesTheFormatOrMustAgree) {
  const auto format = [](const char* text, std::optional<std::string> wanted = {}) {
    return std::string(OutputPattern::parse(text, wanted, {})->format().name);
  };
  EXPECT_EQ(format("a.png"), "png");
  EXPECT_EQ(format("a.HDR"), "hdr");
  EXPECT_EQ(format("a", "hdr"), "hdr");
  EXPECT_EQ(format("-"), "png");
  EXPECT_EQ(format("-", "hdr"), "hdr");
  EXPECT_TRUE(refused("a.jpg"));
  EXPECT_TRUE(refused("a"));
  EXPECT_TRUE(refused("a.png", "hdr"));
  EXPECT_TRUE(refused("a", "tiff"));
}

TEST(StiffCases, E7ASceneNameNeverLeavesTheFolder) {
  const auto plain = [](std::string_view name) { return plain_name(name).value_or("refused"); };
  EXPECT_EQ(plain("demo-2.final"), "demo-2.final");
  EXPECT_EQ(plain("../x"), "_._x");
  EXPECT_EQ(plain("/etc/x"), "_etc_x");
  EXPECT_EQ(plain(std::string_view("x\0y", 3)), "x_y");
  EXPECT_EQ(plain("%s%n"), "_s_n");
  EXPECT_EQ(plain("CON"), "_CON");
  EXPECT_EQ(plain("com1.old"), "_com1.old");
  EXPECT_EQ(plain("context"), "context");
  EXPECT_EQ(plain(""), "scene");
  EXPECT_EQ(plain("."), "_");
  EXPECT_EQ(plain(".."), "__");
  EXPECT_EQ(plain(".hidden"), "_hidden");
  EXPECT_EQ(plain("-rf"), "_rf");
  EXPECT_EQ(plain(std::string(300, 'x')), "refused");
}

TEST(StiffCases, E7EveryByteOfASceneNameStaysOneSafePathPart) {
  for (int a = 0; a < 256; ++a)
    for (const char* frame : {"", ".", "..", "x"}) {
      const std::string name = frame + std::string(1, static_cast<char>(a)) + frame;
      const std::string plain = *plain_name(name);
      EXPECT_EQ(plain.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                        "0123456789_-."),
                std::string::npos);
      EXPECT_NE(plain.front(), '.');
      EXPECT_EQ(std::filesystem::path(plain).filename(), plain);
    }
}

}  // namespace
}  // namespace flatray
