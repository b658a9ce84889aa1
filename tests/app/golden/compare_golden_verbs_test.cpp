#include <gtest/gtest.h>

#include <cstdlib>

#include "app/verb.h"
#include "base/file.h"
#include "image/pfm.h"
#include "image/png.h"
#include "support/own_folder.h"

namespace flatray {
namespace {

namespace fs = std::filesystem;

// Runs command lines in a folder of its own; standard output is kept.
class Verbs : public OwnFolder {
 protected:
  Verbs() { ::unsetenv("CI"); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void picture(const std::string& name, int width, std::uint8_t value) const {
    Image image(width, 2, 3);
    image.pixels.assign(image.pixels.size(), value);
    ASSERT_TRUE(write_file(folder_ / name, encode_png(image)));
  }
  int run(const std::vector<std::string>& words) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int code = run_command_line(words);
    out_ = testing::internal::GetCapturedStdout();
    error_ = testing::internal::GetCapturedStderr();
    return code;
  }
  int compare(const std::string& a, const std::string& b, std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"compare", path(a), path(b)});
    return run(more);
  }
  int golden(std::vector<std::string> words) {
    words.insert(words.begin(), "golden");
    words.insert(words.end(), {"--root", folder_.string()});
    return run(words);
  }

  std::string out_, error_;
};

TEST_F(Verbs, CompareTellsEqualFromDifferentByItsExitCode) {
  picture("a.png", 3, 10);
  picture("b.png", 3, 10);
  picture("c.png", 3, 12);
  EXPECT_EQ(compare("a.png", "b.png"), 0);
  EXPECT_EQ(out_, "equal\n");
  EXPECT_EQ(compare("c.png", "a.png"), 1);
  EXPECT_EQ(out_, "worst pixel (0, 0) red: 12, expected 10; 6 of 6 pixels differ\n");
}

TEST_F(Verbs, CompareRefusesWhatItCannotJudge) {
  picture("a.png", 3, 10);
  picture("wide.png", 4, 10);
  picture("folder/a.png", 3, 10);
  ASSERT_TRUE(write_file(folder_ / "text.png", std::string("no picture")));
  EXPECT_EQ(run({"compare", path("a.png")}), 2);
  EXPECT_EQ(compare("a.png", "folder"), 2);
  EXPECT_EQ(compare("a.png", "a.png", {"--metric", "psnrr"}), 2);
  EXPECT_NE(error_.find("did you mean 'psnr'?"), std::string::npos) << error_;
  EXPECT_EQ(compare("a.png", "none.png"), 3);
  EXPECT_EQ(compare("a.png", "wide.png"), 4);
  EXPECT_NE(error_.find("3 x 2 RGB against 4 x 2 RGB"), std::string::npos) << error_;
  EXPECT_EQ(compare("text.png", "a.png"), 4);
}

TEST_F(Verbs, CompareMatchesFoldersByName) {
  for (const char* name : {"a/1.png", "b/1.png", "a/deep/2.png", "b/deep/2.png"})
    picture(name, 3, 10);
  EXPECT_EQ(compare("a", "b"), 0);
  EXPECT_EQ(out_, "1.png: equal\ndeep/2.png: equal\n2 pictures, 0 of them different\n");
  picture("b/deep/2.png", 3, 11);
  EXPECT_EQ(compare("a", "b", {"--diff", path("d")}), 1);
  EXPECT_EQ(read_png(path("d/deep/2.png"))->pixels.front(), 16);
  EXPECT_EQ(read_png(path("d/1.png"))->pixels.front(), 0);
  picture("a/3.PNG", 3, 10);
  EXPECT_EQ(compare("a", "b"), 3);
  EXPECT_NE(error_.find(path("b/3.PNG") + ": error: is missing"), std::string::npos) << error_;
  fs::create_directories(folder_ / "empty");
  EXPECT_EQ(compare("empty", "empty"), 3);
}

TEST_F(Verbs, CompareOfFoldersTellsAllThatCanBeTold) {
  for (const char* name : {"a/1.png", "b/1.png", "a/2.png"}) picture(name, 3, 10);
  picture("b/2.png", 4, 10);
  EXPECT_EQ(compare("a", "b", {"--json"}), 4);
  EXPECT_NE(error_.find("a/2.png: error: "), std::string::npos) << error_;
  for (const char* part : {"\"equal\":false", "1.png\",\"equal\":true", "\"errors\":"})
    EXPECT_NE(out_.find(part), std::string::npos) << part << " is not in\n" << out_;
}

TEST_F(Verbs, CompareTellsWhatItDoesNotFollow) {
  for (const char* name : {"a/1.png", "b/1.png", "far/2.png"}) picture(name, 3, 10);
  fs::create_directory_symlink(folder_ / "far", folder_ / "a/deep");
  EXPECT_EQ(compare("a", "b"), 3);
  EXPECT_NE(error_.find("a/deep: error: is a link to a folder"), std::string::npos) << error_;
  fs::remove(folder_ / "a/deep");
  fs::create_symlink(folder_ / "far/2.png", folder_ / "a/2.png");
  picture("b/2.png", 3, 10);
  fs::create_directories(folder_ / "root");
  for (const char* name : {"a", "b"}) fs::rename(folder_ / name, folder_ / "root" / name);
  EXPECT_EQ(compare("root/a", "root/b"), 0);
  EXPECT_EQ(compare("root/a", "root/b", {"--root", path("root")}), 2);
  EXPECT_NE(error_.find("a/2.png: error: lies outside of --root"), std::string::npos) << error_;
}

TEST_F(Verbs, CompareWritesTheDifferenceAndTheMetric) {
  picture("a.png", 3, 10);
  picture("b.png", 3, 13);
  EXPECT_EQ(compare("a.png", "b.png", {"--diff", path("d.png"), "--metric", "mean"}), 1);
  EXPECT_EQ(read_png(path("d.png"))->pixels.front(), 48);
  EXPECT_NE(out_.find("\n  mean 3\n"), std::string::npos) << out_;
  EXPECT_EQ(compare("a.png", "b.png", {"--json"}), 1);
  for (const char* part : {"\"schema\":\"flatray.compare/1\"", "\"equal\":false", "\"worst\":3"})
    EXPECT_NE(out_.find(part), std::string::npos) << part << " is not in\n" << out_;
}

TEST_F(Verbs, CompareOfLightTellsOfLight) {
  for (const auto& [name, light] : {std::pair("a/x.pfm", 5.0F), std::pair("b/x.pfm", 8.0F)})
    ASSERT_TRUE(write_file(folder_ / name, encode_pfm({1, 1, {light, 2, 2}})));
  EXPECT_EQ(compare("a/x.pfm", "b/x.pfm", {"--metric", "max"}), 1);
  EXPECT_EQ(out_, "worst pixel (0, 0) red: 5, expected 8; 1 of 1 pixel differs\n  max 3\n");
  EXPECT_EQ(compare("a/x.pfm", "b/x.pfm", {"--json"}), 1);
  EXPECT_NE(out_.find(R"("unit":"light")"), std::string::npos) << out_;
  EXPECT_EQ(compare("a", "b", {"--diff", path("d")}), 1);
  EXPECT_EQ(read_png(path("d/x.pfm.png"))->pixels.front(), 255);
}

constexpr const char* kBoxScene = R"(flatray = 1
film = { size = [16, 10], world = [[0, 0], [16, 10]] }
[[entity]]
name = "box"
shape = { box = { min = [2, 2], max = [5, 6] } }
fill = "#336699"
)";

TEST_F(Verbs, GoldenUpdateNeedsAReasonAndSomeoneWhoLooks) {
  ASSERT_TRUE(write_file(folder_ / "scenes/box.toml", std::string(kBoxScene)));
  EXPECT_EQ(golden({"update", "box"}), 2);
  EXPECT_EQ(golden({"update", "box", "--why", "  "}), 2);
  ::setenv("CI", "true", 1);
  EXPECT_EQ(golden({"update", "box", "--why", "new"}), 2);
  EXPECT_NE(error_.find("accepted by a machine"), std::string::npos) << error_;
  ::unsetenv("CI");
  EXPECT_FALSE(fs::exists(folder_ / "golden_images"));
  EXPECT_EQ(golden({"update", "--why", "new"}), 2);
  EXPECT_EQ(golden({"update", "bix", "--why", "new"}), 3);
}

TEST_F(Verbs, GoldenCheckPassesUntilThePictureChanges) {
  ASSERT_TRUE(write_file(folder_ / "scenes/box.toml", std::string(kBoxScene)));
  EXPECT_EQ(golden({"check"}), 3);
  EXPECT_EQ(golden({"update", "box", "--why", "new"}), 0);
  EXPECT_EQ(
      out_,
      "golden_images/box/frame_0001.png: new\n  look:   out/golden/box/frame_0001/sheet.png\n");
  EXPECT_EQ(golden({"check"}), 0);
  EXPECT_EQ(out_, "1 golden, 0 of them different\n");
  std::string text = kBoxScene;
  text.replace(text.find("#336699"), 7, "#33669a");
  ASSERT_TRUE(write_file(folder_ / "scenes/box.toml", text));
  EXPECT_EQ(golden({"check", "box"}), 1);
  EXPECT_NE(out_.find("blue: 154, expected 153; 12 of 160 pixels differ"), std::string::npos)
      << out_;
  EXPECT_TRUE(fs::exists(folder_ / "out/golden/box/frame_0001/diff_x16.png"));
  EXPECT_EQ(golden({"update", "box", "--why", "bluer"}), 0);
  EXPECT_EQ(golden({"check", "box"}), 0);
  const std::string once = out_;
  EXPECT_EQ(golden({"check", "box", "box.toml", "box"}), 0);
  EXPECT_EQ(out_, once);
}

TEST_F(Verbs, GoldensOfAnotherSizeAreDrawnAsRenderDrawsThem) {
  std::string text = kBoxScene;
  text.replace(text.find("[[0, 0], [16, 10]]"), 18, "\"pixels\"");
  ASSERT_TRUE(write_file(folder_ / "scenes/box.toml", text));
  EXPECT_EQ(golden({"update", "box", "--why", "new", "--size", "32x20"}), 0);
  EXPECT_EQ(run({"render", path("scenes/box.toml"), "--size", "32x20", "-o", path("box.png")}), 0);
  EXPECT_EQ(compare("box.png", "golden_images/box/frame_0001.png"), 0) << out_;
  EXPECT_EQ(golden({"check", "box"}), 0);
  EXPECT_EQ(golden({"update", "box", "--why", "again", "--size", "32x20"}), 0);
  EXPECT_EQ(out_, "golden_images/box/frame_0001.png: same as before\n");
}

TEST_F(Verbs, GoldensBehindLinksThatLeadOutOfTheRootAreNeitherReadNorWritten) {
  ASSERT_TRUE(write_file(folder_ / "scenes/box.toml", std::string(kBoxScene)));
  const fs::path outside = folder_.string() + "_outside";
  fs::create_directories(outside);
  fs::create_directory_symlink(outside, folder_ / "golden_images");
  EXPECT_EQ(golden({"update", "box", "--why", "new"}), 2);
  EXPECT_NE(error_.find("lies outside of --root"), std::string::npos) << error_;
  EXPECT_TRUE(fs::is_empty(outside));
  EXPECT_EQ(golden({"check"}), 2);
  fs::remove_all(outside);
}

TEST_F(Verbs, GoldenCheckNamesWhatIsMissing) {
  ASSERT_TRUE(write_file(folder_ / "scenes/box.toml", std::string(kBoxScene)));
  ASSERT_TRUE(write_file(folder_ / "scenes/other.toml", std::string(kBoxScene)));
  EXPECT_EQ(golden({"update", "box", "--why", "new"}), 0);
  EXPECT_EQ(golden({"check", "other"}), 3);
  ASSERT_TRUE(write_file(folder_ / "golden_images/stray.png", std::string("x")));
  EXPECT_EQ(golden({"check"}), 4);
  EXPECT_NE(error_.find("stray.png: error: has no row"), std::string::npos) << error_;
  fs::remove(folder_ / "golden_images/box/frame_0001.png");
  EXPECT_EQ(golden({"check", "box"}), 3);
  EXPECT_EQ(golden({"chek"}), 2);
}

}  // namespace
}  // namespace flatray
