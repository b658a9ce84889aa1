#include "app/files/manifest.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "base/file.h"
#include "base/hash.h"
#include "image/png.h"
#include "support/own_folder.h"

namespace flatray {
namespace {

namespace fs = std::filesystem;

FrameRecord record(unsigned frame) {
  return {frame,
          fmt::format("frame_{:04}.png", frame),
          40,
          30,
          "00000000000000aa",
          "00000000000000bb",
          "00000000000000cc",
          18446744073709551615U,
          "gl: made for this test"};
}

class Manifest : public OwnFolder {
 protected:
  const fs::path path_ = folder_ / "manifest.jsonl";
};

TEST_F(Manifest, ALineReadsBackAsItsRecord) {
  FrameRecord odd = record(3);
  odd.file = "a \"quoted\"\n\\ \xC3\xA4.png";
  EXPECT_EQ(parse_manifest_line(manifest_line(odd)), odd);
  EXPECT_EQ(manifest_line(odd).find('\n'), std::string::npos);
}

TEST_F(Manifest, ALineIsCompactJsonWithItsFrameFirst) {
  EXPECT_EQ(
      manifest_line(record(3)),
      R"({"frame":3,"file":"frame_0003.png","width":40,"height":30,"pixels":"00000000000000aa",)"
      R"("bytes":"00000000000000bb","scene":"00000000000000cc","seed":18446744073709551615,"backend":"gl: made for this test"})");
}

// Light that is followed from its pixels has no rounds, and no ends that could be told.
TEST_F(Manifest, OfLightFromPixelsTheNumberOfPathsIsTold) {
  LightReport report;
  report.counts.rays = 1000;
  FrameRecord backward = record(1), forward = record(1);
  backward.light = record_of(report);
  EXPECT_NE(manifest_line(backward).find(R"("light":{"rays":1000}})"), std::string::npos)
      << manifest_line(backward);
  EXPECT_EQ(parse_manifest_line(manifest_line(backward)), backward);
  report.rounds = 2;
  report.counts.emitted = report.counts.escaped = 8;
  forward.light = record_of(report);
  EXPECT_NE(manifest_line(forward).find(R"("rounds":2,"absorbed":0,"escaped":1,)"),
            std::string::npos)
      << manifest_line(forward);
  EXPECT_EQ(parse_manifest_line(manifest_line(forward)), forward);
}

TEST_F(Manifest, ALineThatNamesNoBackEndIsOfTheSoftwareOne) {
  std::string line = manifest_line(record(3));
  line.replace(line.find(",\"backend\""), std::string::npos, "}");
  EXPECT_EQ(parse_manifest_line(line).value().backend, "software");
}

TEST_F(Manifest, NoTornLineIsARecord) {
  const std::string line = manifest_line(record(3));
  for (std::size_t length = 0; length < line.size(); ++length)
    EXPECT_FALSE(parse_manifest_line(line.substr(0, length))) << length;
}

TEST_F(Manifest, WhatIsNoRecordIsPassedOver) {
  for (const std::string& text :
       {std::string("null"), std::string("[]"), std::string("{}"), std::string("\"frame\""),
        std::string(R"({"frame":-1,"file":"x","bytes":"y"})"),
        std::string(R"({"frame":"1","file":"x","bytes":"y"})"),
        std::string(R"({"frame":1,"file":"../x","bytes":"y"})"), std::string(100000, '[')})
    EXPECT_FALSE(parse_manifest_line(text)) << text.substr(0, 40);
}

TEST_F(Manifest, TheLastLineOfAFileCountsAndATornOneDoesNot) {
  FrameRecord again = record(1);
  again.scene = "00000000000000dd";
  const Records records =
      records_of(manifest_line(record(1)) + "\ngarbage\n" + manifest_line(record(2)) + "\n" +
                 manifest_line(again) + "\n" + manifest_line(record(3)).substr(0, 50));
  ASSERT_EQ(records.size(), 2U);
  EXPECT_EQ(records.at("frame_0001.png"), again);
  EXPECT_EQ(records.at("frame_0002.png"), record(2));
}

TEST_F(Manifest, ThoseOfAllShardsAreFound) {
  for (const char* name :
       {"manifest.jsonl", "manifest.1-of-2.jsonl", "timings.jsonl", "manifest.csv"})
    ASSERT_TRUE(write_file(folder_ / name, std::string()));
  EXPECT_EQ(manifests_in(folder_),
            (std::vector<fs::path>{folder_ / "manifest.1-of-2.jsonl", path_}));
  EXPECT_TRUE(manifests_in(folder_ / "none").empty());
}

TEST_F(Manifest, ShardsHaveTheirOwn) {
  EXPECT_EQ(manifest_path("out", {0, 1}), "out/manifest.jsonl");
  EXPECT_EQ(manifest_path("out", {2, 3}), "out/manifest.2-of-3.jsonl");
  EXPECT_EQ(timings_path("out", {2, 3}), "out/timings.2-of-3.jsonl");
}

TEST_F(Manifest, AFrameIsWholeOnlyWhenEveryByteIs) {
  Image image(40, 30, 3);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = static_cast<std::uint8_t>(i * i / 7);
  const std::vector<std::byte> bytes = encode_png(image);
  FrameRecord made = record(1);
  made.pixels = pixel_hash(image);
  made.bytes = Hash().add(bytes).hex();
  const fs::path file = folder_ / made.file;
  EXPECT_FALSE(is_whole(made, folder_)) << "not there";
  ASSERT_TRUE(write_file(file, bytes));
  EXPECT_TRUE(is_whole(made, folder_));
  for (const std::size_t cut :
       {std::size_t{0}, std::size_t{8}, bytes.size() / 2, bytes.size() - 1}) {
    ASSERT_TRUE(write_file(file, std::span(bytes).first(cut)));
    EXPECT_FALSE(is_whole(made, folder_)) << cut;
  }
  std::vector<std::byte> wrong = bytes;
  wrong[bytes.size() / 2] ^= std::byte{1};
  ASSERT_TRUE(write_file(file, wrong));
  EXPECT_FALSE(is_whole(made, folder_)) << "one bit";
  ASSERT_TRUE(write_file(file, bytes));
  for (FrameRecord lie : {made, made, made}) {
    static int field = 0;
    if (field == 0) lie.width = 41;
    if (field == 1) lie.pixels = "0000000000000000";
    if (field == 2) lie.bytes = "0000000000000000";
    EXPECT_FALSE(is_whole(lie, folder_)) << field;
    ++field;
  }
}

}  // namespace
}  // namespace flatray
