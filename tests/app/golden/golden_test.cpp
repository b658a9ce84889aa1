#include "app/golden/golden.h"

#include <gtest/gtest.h>

#include "app/golden/golden_check.h"
#include "app/golden/golden_update.h"
#include "base/file.h"
#include "image/png.h"
#include "support/own_folder.h"

namespace flatray {
namespace {

namespace fs = std::filesystem;

constexpr const char* kGoldenScene = R"(flatray = 1
frames = 9
film = { size = [16, 10], world = [[0, 0], [16, 10]] }
[[entity]]
name = "box"
shape = { box = { min = [0, 0], max = [3.5, 2.5] } }
at = [1, 1]
velocity = [24, 0]
fill = "#336699"
)";

// A project of one scene in a folder of its own.
class Golden : public OwnFolder {
 protected:
  Golden() { write("scenes/part/dot.toml", kGoldenScene); }

  void write(const std::string& path, const std::string& text) const {
    ASSERT_TRUE(write_file(folder_ / path, text));
  }
  void edit(const std::string& path, const std::string& from, const std::string& to) const {
    std::string text = read_file(folder_ / path).value();
    ASSERT_NE(text.find(from), std::string::npos) << text;
    write(path, text.replace(text.find(from), from.size(), to));
  }
  std::vector<GoldenRow> rows() const {
    return read_goldens(folder_).value_or(std::vector<GoldenRow>());
  }

  Result<GoldenUpdate> plan(const GoldenRequest& request) const {
    return plan_update(folder_, rows(), request);
  }
  GoldenUpdate accept(const GoldenRequest& request) const {
    Result<GoldenUpdate> update = plan(request);
    EXPECT_TRUE(update) << (update ? "" : format(update.error()));
    if (!update) return {};
    EXPECT_TRUE(write_update(folder_, *update));
    return std::move(*update);
  }
  void expect_refused(const GoldenRequest& request, const std::string& why) const {
    const Result<GoldenUpdate> refused = plan(request);
    ASSERT_FALSE(refused) << why;
    EXPECT_EQ(refused.error().front().trouble, Trouble::usage);
    EXPECT_NE(refused.error().front().message.find(why), std::string::npos)
        << format(refused.error());
    EXPECT_FALSE(refused.error().front().hint.empty());
  }
  GoldenCheck checked(std::size_t row) const {
    Result<GoldenCheck> check = check_golden(folder_, rows().at(row));
    EXPECT_TRUE(check) << (check ? "" : format(check.error()));
    return check ? std::move(*check) : GoldenCheck{};
  }

  const GoldenRequest kThird{"scenes/part/dot.toml", "first", std::vector<unsigned>{3},
                             std::nullopt};
};

TEST_F(Golden, WhatIsAcceptedPassesItsCheck) {
  accept(kThird);
  ASSERT_EQ(rows().size(), 1U);
  EXPECT_EQ(rows()[0].file(), "golden_images/part_dot/frame_0003.png");
  EXPECT_EQ(rows()[0].name(), "part/dot");
  EXPECT_EQ(rows()[0].drift, "max=0;pixels=0");
  const GoldenCheck check = checked(0);
  EXPECT_TRUE(check.passes());
  EXPECT_FALSE(check.scene_changed);
  EXPECT_GT(compare(check.expected, Image(16, 10, check.expected.channels))->pixels, 0U);
}

TEST_F(Golden, AnotherSceneFailsAndTheReportSaysAllOfIt) {
  accept(kThird);
  edit("scenes/part/dot.toml", "#336699", "#336799");
  const GoldenCheck check = checked(0);
  EXPECT_FALSE(check.passes());
  const std::string report = golden_report(rows()[0], check);
  EXPECT_EQ(report,
            "part/dot frame 3: differs from golden_images/part_dot/frame_0003.png (software: must "
            "be equal)\n"
            "  worst pixel (3, 7) green: 103, expected 102; 6 of 160 pixels differ\n"
            "  cause:  scenes/part/dot.toml has changed since the picture was accepted\n"
            "  look:   out/golden/part_dot/frame_0003/{actual,expected,diff_x16}.png\n"
            "  replay: flatray render scenes/part/dot.toml -f 3 -o dot.png\n"
            "  accept: flatray golden update part/dot --why \"...\"\n");
  ASSERT_TRUE(write_look(folder_, rows()[0], check));
  const fs::path look = folder_ / rows()[0].look();
  EXPECT_TRUE(read_png((look / "actual.png").string()) == check.actual);
  EXPECT_TRUE(read_png((look / "expected.png").string()) == check.expected);
  EXPECT_EQ(read_png((look / "diff_x16.png").string())->at(4, 7)[1], 16);
}

TEST_F(Golden, TheReportsCommandsAreReadByAShellAsTheyAreMeant) {
  accept(kThird);
  GoldenRow row = rows()[0];
  row.scene = "scenes/part/it's; a $dot.toml";
  const std::string report = golden_report(row, judge(Image(4, 3, 3), Image(3, 4, 4)));
  EXPECT_NE(report.find(R"(flatray render 'scenes/part/it'\''s; a $dot.toml' -f 3 -o )"
                        R"('it'\''s; a $dot.png')"
                        "\n"),
            std::string::npos)
      << report;
  EXPECT_NE(report.find(R"(flatray golden update 'part/it'\''s; a $dot' --why)"), std::string::npos)
      << report;
}

TEST_F(Golden, AnEditThatChangesNoPixelPasses) {
  accept(kThird);
  edit("scenes/part/dot.toml", "flatray = 1", "# a comment\nflatray = 1");
  const GoldenCheck check = checked(0);
  EXPECT_TRUE(check.passes());
  EXPECT_TRUE(check.scene_changed);
}

TEST_F(Golden, TheReplayNamesSizeAndSeedWhereTheyAreNotTheScenes) {
  GoldenRequest small = kThird;
  small.size = FilmSize{8, 5};
  accept(small);
  edit("scenes/part/dot.toml", "frames = 9", "frames = 9\nseed = 7");
  const GoldenCheck check = checked(0);
  EXPECT_EQ(check.actual.width, 8);
  EXPECT_TRUE(check.passes());
  EXPECT_EQ(check.options, " --size 8x5 --seed 0");
}

TEST_F(Golden, APictureOfAnotherSizeIsReported) {
  accept(kThird);
  const GoldenCheck check = judge(Image(4, 3, 3), Image(3, 4, 4));
  EXPECT_FALSE(check.passes());
  const std::string report = golden_report(rows()[0], check);
  EXPECT_NE(report.find("picture of 4 x 3 with 3 channels, expected 3 x 4 with 4 channels"),
            std::string::npos);
  EXPECT_NE(report.find("{actual,expected}.png"), std::string::npos);
}

TEST_F(Golden, AnExchangedPictureIsRefused) {
  accept(kThird);
  Image image = checked(0).expected;
  image.pixels[5] = static_cast<std::uint8_t>(image.pixels[5] ^ 1);
  ASSERT_TRUE(write_file(folder_ / rows()[0].file(), encode_png(image)));
  const auto refused = check_golden(folder_, rows()[0]);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().front().message.find("is not the picture its row"), std::string::npos);
}

TEST_F(Golden, APictureThatStaysKeepsItsReason) {
  accept(kThird);
  GoldenRequest both = kThird;
  both.frames = {{3, 4}};
  both.why = "second";
  fs::remove_all(folder_ / "out");  // the sheets of the first acceptance
  const GoldenUpdate update = accept(both);
  EXPECT_TRUE(update.pictures[0].same());
  EXPECT_FALSE(update.pictures[1].same());
  ASSERT_EQ(rows().size(), 2U);
  EXPECT_EQ(rows()[0].why, "first");
  EXPECT_EQ(rows()[1].why, "second");
  EXPECT_FALSE(fs::exists(folder_ / update.pictures[0].sheet()));
  EXPECT_TRUE(fs::exists(folder_ / update.pictures[1].sheet()));
}

TEST_F(Golden, FramesNoLongerWantedGo) {
  GoldenRequest request = kThird;
  request.frames = {{1, 2, 3}};
  accept(request);
  request.frames = {{2}};
  const GoldenUpdate update = accept(request);
  EXPECT_EQ(update.removed.size(), 2U);
  ASSERT_EQ(rows().size(), 1U);
  EXPECT_EQ(rows()[0].frame, 2U);
  EXPECT_TRUE(stray_goldens(folder_, rows())->empty());
}

TEST_F(Golden, FramesStayTheScenesOwnWhereNoneAreNamed) {
  accept(kThird);
  edit("scenes/part/dot.toml", "#336699", "#123456");
  GoldenRequest again = kThird;
  again.frames.reset();
  EXPECT_EQ(accept(again).pictures.at(0).row.frame, 3U);
  EXPECT_TRUE(checked(0).passes());
}

TEST_F(Golden, ChangedPicturesAreShownBesideTheOldOnes) {
  accept(kThird);
  edit("scenes/part/dot.toml", "#336699", "#336799");
  const GoldenUpdate update = accept(kThird);
  const Image sheet = read_png((folder_ / update.pictures[0].sheet()).string()).value();
  EXPECT_EQ(sheet.width, 3 * 16 + 2 * 4);
  EXPECT_EQ(sheet.at(4, 7)[1], 102);
  EXPECT_EQ(sheet.at(20 + 4, 7)[1], 103);
  EXPECT_EQ(sheet.at(40 + 4, 7)[1], 16);
}

TEST_F(Golden, WhatIsTooMuchIsRefusedAndNothingIsWritten) {
  GoldenRequest request = kThird;
  request.size = FilmSize{321, 200};
  expect_refused(request, "321 x 200 pixels are too many");
  request.size = FilmSize{320, 201};
  expect_refused(request, "too many");
  request = kThird;
  request.frames = {{1, 2, 3, 4}};
  expect_refused(request, "4 frames are too many");
  EXPECT_FALSE(fs::exists(folder_ / "golden_images"));
}

TEST_F(Golden, TwoScenesOfOneFolderAreRefused) {
  accept(kThird);
  write("scenes/part_dot.toml", kGoldenScene);
  expect_refused({"scenes/part_dot.toml", "why", std::nullopt, std::nullopt}, "shares part_dot");
}

TEST_F(Golden, TwoMegabytesAreTheLimitForAllTogether) {
  accept(kThird);
  GoldenRow large = rows()[0];
  large.scene = "scenes/other.toml";
  write(large.file(), std::string(2'000'000, 'x'));
  ASSERT_TRUE(write_goldens(folder_, {rows()[0], large}));
  expect_refused(kThird, "all goldens together would have 2000");
}

TEST_F(Golden, ManifestsComeBackAsTheyWere) {
  accept(kThird);
  const std::string before = read_file(folder_ / "golden_images/manifest.json").value();
  ASSERT_TRUE(write_goldens(folder_, rows()));
  EXPECT_EQ(read_file(folder_ / "golden_images/manifest.json").value(), before);
}

TEST_F(Golden, EveryBadRowOfAManifestIsNamed) {
  accept(kThird);
  const std::string manifest = "golden_images/manifest.json";
  edit(manifest, "scenes/part/dot.toml", "scenes/../dot.toml");
  edit(manifest, "\"software\"", "\"vulkan\"");
  edit(manifest, "[16,10]", "[16,1000]");
  edit(manifest, "\"first\"", "\"\"");
  const auto refused = read_goldens(folder_);
  ASSERT_FALSE(refused);
  std::string all = format(refused.error());
  for (const char* key : {"'scene'", "'backend'", "'size'", "'why'", "'file'"})
    EXPECT_NE(all.find(key), std::string::npos) << key << " is not in\n" << all;
}

TEST_F(Golden, WhatIsNoManifestIsRefused) {
  EXPECT_EQ(read_goldens(folder_).error().front().trouble, Trouble::missing);
  for (const char* text :
       {"", "[1, 2", "[]", "{\"schema\": \"flatray.goldens/2\", \"goldens\": []}"}) {
    write("golden_images/manifest.json", text);
    const auto refused = read_goldens(folder_);
    ASSERT_FALSE(refused) << text;
    EXPECT_EQ(refused.error().front().trouble, Trouble::invalid);
  }
  accept(kThird);
}

TEST_F(Golden, ScenesAreFoundByAnyOfTheirNames) {
  for (const char* name :
       {"part/dot", "part/dot.toml", "scenes/part/dot.toml", "./scenes/part/dot.toml"})
    EXPECT_EQ(find_scene(folder_, name).value_or("nothing"), "scenes/part/dot.toml") << name;
  const auto missing = find_scene(folder_, "part/dott");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().front().hint, "did you mean 'part/dot'?");
  write("scenes/part/dot.obj", "");
  EXPECT_EQ(find_scene(folder_, "part/dot").error().front().trouble, Trouble::usage);
}

TEST_F(Golden, PicturesWithoutARowAreStrays) {
  accept(kThird);
  EXPECT_TRUE(stray_goldens(folder_, rows())->empty());
  write("golden_images/part_dot/frame_0009.png", "x");
  EXPECT_EQ(stray_goldens(folder_, rows()),
            std::vector<std::string>{"golden_images/part_dot/frame_0009.png"});
}

}  // namespace
}  // namespace flatray
