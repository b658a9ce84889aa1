// needs: formats/obj
#include "scene/imports/obj_text.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace flatray {
namespace {

constexpr std::size_t kChunk = std::size_t{1} << 18;  // bytes after which the text may be cut

SourcePtr named(const std::string& text) {
  return std::make_shared<const SourceText>("m.obj", text);
}

// `count` vertices (i, i), a line each.
std::string vertices(std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += fmt::format("v {0} {0} 0.5\n", i);
  return text;
}

void expect_same(const ObjText& a, const ObjText& b) {
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.faces.corners, b.faces.corners);
  EXPECT_EQ(a.faces.begin, b.faces.begin);
  EXPECT_EQ(a.lines.corners, b.lines.corners);
  EXPECT_EQ(a.lines.begin, b.lines.begin);
  EXPECT_EQ(a.ignored, b.ignored);
}

TEST(ObjText, ManyChunksGiveEveryRecordOnceAndInOrder) {
  constexpr std::uint32_t kCount = 100'000;
  std::string text = vertices(kCount);
  for (std::uint32_t i = 0; i + 2 < kCount; ++i)
    text += fmt::format("{} {} {} {}\n", i % 2 == 0 ? "f" : "l", i + 1, i + 2, i + 3);
  ASSERT_GT(text.size(), 8 * kChunk);
  const SourcePtr source = named(text);
  const auto obj = parse_obj(source, 1);
  ASSERT_TRUE(obj) << format(obj.error());
  ASSERT_EQ(obj->vertices.size(), kCount);
  for (std::uint32_t i = 0; i < kCount; ++i) ASSERT_EQ(obj->vertices[i], Vec2(i, i));
  ASSERT_EQ(obj->faces.size(), (kCount - 2) / 2);
  ASSERT_EQ(obj->lines.size(), (kCount - 2) / 2);
  for (std::uint32_t i = 0; i < obj->faces.size(); ++i)
    for (std::uint32_t k = 0; k < 3; ++k) {
      ASSERT_EQ(obj->faces.corners[obj->faces.begin[i] + k], 2 * i + k);
      ASSERT_EQ(obj->lines.corners[obj->lines.begin[i] + k], 2 * i + 1 + k);
    }
  for (const unsigned threads : {2u, 3u, 7u}) expect_same(*parse_obj(source, threads), *obj);
}

TEST(ObjText, NumbersCountedBackwardsReachIntoEarlierChunks) {
  constexpr std::size_t kCount = 40'000;
  std::string text = vertices(kCount);
  ASSERT_GT(text.size(), 2 * kChunk);
  text += fmt::format("f -{} -1 -20000\nv 7 7\nf -1 -{} 5\n", kCount, kCount + 1);
  const auto obj = parse_obj(named(text), 3);
  ASSERT_TRUE(obj) << format(obj.error());
  EXPECT_EQ(obj->faces.corners, (std::vector<std::uint32_t>{0, 39'999, 20'000, 40'000, 0, 4}));
}

// The cut slides over a record with continued lines, byte by byte.
TEST(ObjText, NoCutFallsIntoARecord) {
  const std::string record = "f 1 2 \\\r\n3 \\\n4\n# not continued \\\nv 2 5\r\nl 1 \\\n2\n";
  const std::string head = "v 0 0\nv 1 0\nv 1 1\nv 0 1\n#";
  for (std::size_t shift = 0; shift <= record.size(); ++shift) {
    const std::string filling(kChunk - head.size() - 1 - shift, '.');
    const auto obj = parse_obj(named(head + filling + "\n" + record + record), 2);
    ASSERT_TRUE(obj) << shift << format(obj.error());
    EXPECT_EQ(obj->faces.corners, (std::vector<std::uint32_t>{0, 1, 2, 3, 0, 1, 2, 3})) << shift;
    EXPECT_EQ(obj->lines.corners, (std::vector<std::uint32_t>{0, 1, 0, 1})) << shift;
    EXPECT_EQ(obj->vertices.size(), 6u) << shift;
  }
}

TEST(ObjText, ARecordLongerThanAChunkIsRead) {
  std::string text = vertices(3) + "f";
  while (text.size() < 3 * kChunk) text += " 1 2 \\\n 3";
  const auto obj = parse_obj(named(text + "\nl 1 2"), 2);
  ASSERT_TRUE(obj);
  EXPECT_EQ(obj->faces.size(), 1u);
  EXPECT_EQ(obj->lines.size(), 1u);
}

Diagnostics mistakes(const std::string& text, unsigned threads) {
  const auto obj = parse_obj(named(text), threads);
  return obj ? Diagnostics{} : obj.error();
}

TEST(ObjText, MistakesOfAllChunksAreToldInTheOrderOfTheText) {
  constexpr std::size_t kCount = 60'000;
  std::string text;
  for (std::size_t i = 0; i < kCount; ++i)
    text += i % 6000 == 5999 ? fmt::format("v {} x\n", i) : fmt::format("v {0} {0} 0.5\n", i);
  text += "f 1 2 60000\nf 1 2 60001\nl -60000 -60001\n";
  const Diagnostics one = mistakes(text, 1);
  ASSERT_EQ(one.size(), 12u);
  for (std::size_t i = 0; i < 10; ++i) {
    const auto at = one[i].where.source->position(one[i].where.offset);
    EXPECT_EQ(at.line, static_cast<int>(6000 * (i + 1)));
    EXPECT_EQ(at.column, i == 0 ? 8 : 9);
    EXPECT_EQ(one[i].message, "'x' is not a finite number");
  }
  EXPECT_NE(format(one[10]).find("m.obj:60002:7: error: there is no such vertex"),
            std::string::npos);
  EXPECT_NE(format(one[11]).find("m.obj:60003:10: error: there is no such vertex"),
            std::string::npos);
  EXPECT_EQ(one[10].hint, "the file has 60000 vertices");
  for (const unsigned threads : {2u, 5u}) EXPECT_EQ(format(mistakes(text, threads)), format(one));
}

TEST(ObjText, TheFirstTwentyMistakesAreToldWhateverTheThreads) {
  std::string text;
  for (int i = 0; i < 100'000; ++i) text += "v 1 2 3\nv 1,5 2\n";
  const Diagnostics one = mistakes(text, 1);
  ASSERT_EQ(one.size(), 20u);
  EXPECT_EQ(one.back().where.source->position(one.back().where.offset).line, 40);
  for (const unsigned threads : {2u, 5u}) EXPECT_EQ(format(mistakes(text, threads)), format(one));
}

TEST(ObjText, NumbersBeyondAnyTextAreNoVertices) {
  for (const char* number :
       {"2147483647", "2147483648", "4294967297", "999999999999999999", "9223372036854775807",
        "-2147483648", "-4294967296", "-9223372036854775808"}) {
    const Diagnostics found = mistakes(vertices(3) + fmt::format("f 1 2 {}\n", number), 1);
    ASSERT_EQ(found.size(), 1u) << number;
    EXPECT_EQ(found[0].message, "there is no such vertex") << number;
    EXPECT_EQ(found[0].where.length, std::string_view(number).size()) << number;
  }
}

TEST(ObjText, TheFirstEightRecordsPassedOverAreNamed) {
  std::string text;
  for (int i = 0; i < 60'000; ++i) text += fmt::format("x{} 1\nx0 2\n", i / 10'000);
  text += "a\nb\nc\nd\n";
  const auto obj = parse_obj(named(text), 2);
  ASSERT_TRUE(obj);
  EXPECT_EQ(obj->ignored, (std::vector<std::string>{"x0", "x1", "x2", "x3", "x4", "x5", "a", "b"}));
}

}  // namespace
}  // namespace flatray
