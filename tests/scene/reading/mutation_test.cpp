// needs: shapes/polygon shapes/import formats/list formats/obj
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/file.h"
#include "base/philox.h"
#include "scene/reading/file_names.h"
#include "scene/reading/format.h"
#include "scene/reading/write_toml.h"
#include "scene/scene_text.h"
#include "support/paths.h"

namespace flatray {
namespace {

constexpr const char* kToml = R"(flatray = 1
film = { size = [32, 20], world = [[-1, -2], [30, 40]], background = "#01020304" }
camera = { follow = "runner", offset = [3, 4] }
[[entity]]
name = "runner"
shape = { polygon = { points = [[0, 0], [4, 0], [4, 4], [2, 1], [0, 4]] } }
velocity = [12, 0.5]
stroke = { width = 0.5, colour = "#102030" }
markov = { chain = "run", start = "RUN" }
states = { RUN = [{ fill = "#000001" }, { fill = "none" }] }
follow = { path = [[0, 0], [3, 4]], speed = 2, turn = true }
[[group]]
name = "g"
at = { keys = [[0, [1, 2]], [1.5, [3, { uniform = [4, 5] }]]], ease = "smooth" }
repeat = { ring = { count = 3, radius = 2, turn = true } }
[[entity]]
group = "g"
shape = { choice = [{ polygon = { points = [[0, 0], [{ normal = [4, 1] }, 0], [0, 4]] } }] }
repeat = { scatter = { count = 4, in = [[0, 0], [1, 1]] } }
[[ray]]
at = [15, 5]
direction = [1, -1e-3]
[markov.run]
hold = 10
RUN = { RUN = 0.25, DIE = 0.75 }
DIE = { DIE = 1 }
)";
constexpr const char* kObj =
    "v 0 0 1\nv 4 0\nv 4 4 # x\nv 2 1\nv 0 4\nvt 0 0\nf 1/1 2/1 3/1 4/1 5/1\nf -1 -2 \\\n-3\nl 1 2 "
    "3\n";
constexpr const char* kList = "{ SPIDER MAN, 200,200}\nBAT, 1.5, -2e1\n# end\n";

// What turns up in damaged scenes more often than among all bytes.
constexpr std::string_view kBytes = "[]{}=,.\"'#\n\r\\-+eE0919_/ aZ\0\x7f\xc3\xa9\xff";

// One to four bytes changed, put in or taken out. The draws are named by the round, so a failure is
// its number.
std::string damaged(std::string text, std::uint64_t round) {
  const auto draw = [&](std::uint64_t item, std::uint64_t below) {
    return static_cast<std::size_t>(random_bits(2, Stream::test, round, item) % below);
  };
  const std::size_t changes = 1 + draw(0, 4);
  for (std::size_t i = 0; i < changes && !text.empty(); ++i) {
    const std::size_t at = draw(4 * i + 1, text.size());
    const char byte = kBytes[draw(4 * i + 2, kBytes.size())];
    switch (draw(4 * i + 3, 3)) {
      case 0:
        text[at] = byte;
        break;
      case 1:
        text.insert(at, 1, byte);
        break;
      default:
        text.erase(at, 1 + draw(4 * i + 4, 5));
    }
  }
  return text;
}

void expect_answers(const std::string& name, const std::string& text, std::uint64_t rounds) {
  ASSERT_TRUE(load_scene_text(name, text));
  std::size_t refused = 0;
  for (std::uint64_t round = 0; round < rounds; ++round) {
    const auto got = load_scene_text(name, damaged(text, round));
    if (got) continue;
    ++refused;
    for (const Diagnostic& problem : got.error()) {
      EXPECT_TRUE(problem.where) << round;
      EXPECT_FALSE(problem.message.empty()) << round;
    }
    EXPECT_FALSE(format(got.error()).empty());
  }
  EXPECT_GT(refused, rounds / 10);
  EXPECT_LT(refused, rounds);
}

TEST(Mutations, OfATomlSceneAreReadOrRefused) { expect_answers("m.toml", kToml, 1000); }
TEST(Mutations, OfAnObjAreReadOrRefused) { expect_answers("m.obj", kObj, 1000); }
TEST(Mutations, OfAChamberAreReadOrRefused) {
  expect_answers("m.chamber", "2\n4 1 0 0.5\n0 0 8 0 8 6 0 6\n3 0 1 0\n1 1 2 1 1 2\n", 1000);
}
TEST(Mutations, OfAListAreReadOrRefused) { expect_answers("m.list", kList, 1000); }

constexpr const char* kExtremes[] = {"0",    "-0.0",       "1e300", "-1e300",    "5e-324",
                                     "1e17", "2147483648", "1e-17", "180",       "0.5",
                                     "-1",   "nan",        "1000",  "4294967296"};

// One number made extreme, after the damage.
std::string with_extreme(std::string text, std::uint64_t round) {
  constexpr std::string_view kDigits = "0123456789";
  std::size_t at = random_bits(3, Stream::test, round, 0) % text.size();
  at = text.find_first_of(kDigits, at);
  if (at == std::string::npos) return text;
  const std::size_t end = std::min(text.find_first_not_of("0123456789.eE+-", at), text.size());
  const std::uint64_t draw = random_bits(3, Stream::test, round, 1);
  return text.replace(at, end - at, kExtremes[draw % std::size(kExtremes)]);
}

// Without the flush to the disk of write_file.
void put(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

// What is accepted is written so that it is accepted, and draws from the same numbers.
void expect_converted(const std::string& extension, const std::string& text, std::uint64_t first,
                      std::uint64_t rounds, std::size_t& accepted) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(testing::TempDir()) / "flatray_mutations";
  const fs::path file = folder / ("m" + extension);
  fs::create_directories(folder);
  for (std::uint64_t round = first; round < first + rounds; ++round) {
    const std::string mutant = round % 2 == 0 ? with_extreme(text, round) : damaged(text, round);
    put(file, mutant);
    Result<ReadScene> read = read_scene(file, {}, {.max_entities = 300});
    if (!read) continue;
    ++accepted;
    ASSERT_TRUE(rebase_file_names(read->desc, file, folder));
    const std::string written = write_toml(read->desc);
    put(folder / "w.toml", written);
    const Result<LoadedScene> again = load_scene(folder / "w.toml");
    ASSERT_TRUE(again) << round << "\n"
                       << mutant << "\nwritten as\n"
                       << written << format(again.error());
    EXPECT_EQ(again->scene.entities.size(), read->loaded.scene.entities.size()) << mutant;
  }
}

TEST(Mutations, WhatIsAcceptedIsConvertedToWhatIsAccepted) {
  std::size_t accepted = 0;
  for (const auto& [extension, text] :
       {std::pair{".toml", kToml}, {".obj", kObj}, {".list", kList}})
    expect_converted(extension, text, 0, 100, accepted);
  std::uint64_t first = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(source_path("/scenes"))) {
    const std::string extension = entry.path().extension().string();
    if (format_for_name(entry.path().string()) == nullptr || entry.file_size() > 10'000) continue;
    const Result<std::string> text = read_file(entry.path());
    ASSERT_TRUE(text);
    if (text->find("include") != std::string::npos || text->find("file = ") != std::string::npos)
      continue;
    expect_converted(extension, *text, first += 1000, 2, accepted);
  }
  EXPECT_GT(accepted, 100U);
}

TEST(Mutations, TheSameSceneGivesTheSameMessages) {
  for (std::uint64_t round = 0; round < 50; ++round) {
    const std::string text = damaged(kToml, round);
    EXPECT_EQ(refusal(text), refusal(text));
  }
}

}  // namespace
}  // namespace flatray
