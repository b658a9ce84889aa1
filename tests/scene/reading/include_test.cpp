// needs: shapes/circle shapes/import formats/list formats/obj
#include "base/file.h"
#include "scene/scene_text.h"
#include "support/own_folder.h"

namespace flatray {
namespace {

namespace fs = std::filesystem;

const std::string kNamedDisc = "[[entity]]\nshape = { circle = { radius = 1 } }\nname = ";

// Scenes in a folder.
class Includes : public OwnFolder {
 protected:
  void write(const std::string& file, const std::string& text) {
    ASSERT_TRUE(write_file(folder_ / file, text));
  }
  void scene(const std::string& file, const std::string& text) {
    write(file, "flatray = 1\n" + text);
  }
  Result<LoadedScene> read(const std::string& file = "main.toml", const LoadLimits& limits = {}) {
    return load_scene(folder_ / file, {}, limits);
  }
  Scene loaded(const std::string& file = "main.toml") {
    Result<LoadedScene> result = read(file);
    FLATRAY_CHECK(result.has_value(), result ? "" : format(result.error()));
    return std::move(result->scene);
  }
  // What is printed, the folder's name left out.
  std::string refused(const LoadLimits& limits = {}) {
    const Result<LoadedScene> result = read("main.toml", limits);
    std::string shown = result ? "" : format(result.error());
    const std::string here = folder_.string() + "/";
    for (std::size_t at; (at = shown.find(here)) != std::string::npos;)
      shown.erase(at, here.size());
    return shown;
  }
  std::vector<std::string> names(const Scene& scene) {
    std::vector<std::string> all;
    for (const Entity& one : scene.entities) all.push_back(one.name);
    return all;
  }
};

using Names = std::vector<std::string>;

TEST_F(Includes, ComeBeforeWhatIncludesThem) {
  scene("main.toml", "include = [\"a.toml\", \"b.toml\"]\nfps = 5\n" + kNamedDisc + "\"main\"");
  scene("a.toml", "fps = 7\nframes = 3\nseed = 4\n" + kNamedDisc + "\"a\"");
  scene("b.toml", "frames = 9\n" + kNamedDisc + "\"b\"");
  const Scene made = loaded();
  EXPECT_EQ(names(made), (Names{"a", "b", "main"}));
  EXPECT_LT(made.entities[0].order, made.entities[1].order);
  EXPECT_LT(made.entities[1].order, made.entities[2].order);
  EXPECT_EQ(made.fps, 5);
  EXPECT_EQ(made.frames, 9u);
  EXPECT_EQ(made.seed, 4u);
}

TEST_F(Includes, FilmAndCameraAreMergedKeyByKey) {
  scene("main.toml", "include = [\"a.toml\"]\nfilm = { size = [10, 20] }");
  scene("a.toml", "film = { size = [3, 3], background = \"#010203\" }\n[markov.c]\nA = { A = 1 }");
  const Scene made = loaded();
  EXPECT_EQ(made.film.width, 10);
  EXPECT_EQ(made.film.background, (Colour{1, 2, 3, 255}));
  EXPECT_EQ(made.chains.size(), 1u);
}

TEST_F(Includes, OfManyTheLaterWinAndComeLater) {
  std::string files;
  Names expected;
  for (int i = 0; i < 7; ++i) {
    const std::string number = std::to_string(i), name = "part" + number;
    scene(name + ".toml", "fps = " + std::to_string(i + 1) + (i < 5 ? "\nseed = " + number : "") +
                              "\n[markov.c]\nS" + number + " = { S" + number + " = 1 }\n" +
                              kNamedDisc + "\"" + name + "\"");
    files += "\"" + name + ".toml\", ";
    expected.push_back(name);
  }
  scene("main.toml", "include = [" + files + "]");
  const Scene made = loaded();
  EXPECT_EQ(names(made), expected);
  EXPECT_EQ(made.fps, 7);
  EXPECT_EQ(made.seed, 4U);
  ASSERT_EQ(made.chains.size(), 1U);
  EXPECT_EQ(made.chains[0].states, (Names{"S6"}));
}

TEST_F(Includes, PathsStartAtTheFileThatHasThem) {
  scene("main.toml", "include = [\"parts/a.toml\"]\n");
  scene("parts/a.toml",
        "include = [\"deep/b.toml\", \"../c.list\"]\n[[entity]]\nname = \"o\"\n"
        "shape = { import = { file = \"o.obj\" } }\n");
  scene("parts/deep/b.toml", kNamedDisc + "\"b\"");
  write("parts/o.obj", "v 0 0\nv 1 0\nv 0 1\nf 1 2 3\n");
  write("c.list", "{ BLOCK, 1, 2 }\n");
  EXPECT_EQ(names(loaded()), (Names{"b", "BLOCK", "o"}));
}

TEST_F(Includes, AnOutlineMayBeIncluded) {
  scene("main.toml", "include = [\"o.obj\"]\n");
  write("o.obj", "v 0 0\nv 1 0\nv 0 1\nf 1 2 3\n");
  EXPECT_EQ(names(loaded()), (Names{"o"}));
}

TEST_F(Includes, AFileCountsOnce) {
  scene("main.toml", "include = [\"a.toml\", \"b.toml\", \"./sub/../a.toml\"]\n");
  scene("a.toml", "include = [\"c.toml\"]\n" + kNamedDisc + "\"a\"");
  scene("b.toml", "include = [\"c.toml\"]\n" + kNamedDisc + "\"b\"");
  scene("c.toml", kNamedDisc + "\"c\"");
  fs::create_directories(folder_ / "sub");
  EXPECT_EQ(names(loaded()), (Names{"c", "a", "b"}));
}

TEST_F(Includes, TheTextOfEveryFileIsInTheHash) {
  scene("main.toml", "include = [\"a.toml\"]\n");
  scene("a.toml", kNamedDisc + "\"a\"");
  const std::uint64_t before = loaded().hash;
  EXPECT_EQ(loaded().hash, before);
  scene("a.toml", kNamedDisc + "\"a\" # changed");
  EXPECT_NE(loaded().hash, before);
}

TEST_F(Includes, MistakesNameTheFileAndTheWayToIt) {
  scene("main.toml", "\ninclude = [\"a.toml\"]\n" + kNamedDisc + "3\n");
  scene("a.toml", "include = [\"b.toml\"]\n");
  scene("b.toml", "fps = 0\n");
  EXPECT_EQ(refused(), R"(b.toml:2:7: error: fps is not above 0
    fps = 0
          ^  write frames a second
    named at a.toml:2:12
    named at main.toml:3:12
main.toml:6:8: error: entity.name is a number, not a string
    name = 3
           ^  write name = "NAME"
)");
}

TEST_F(Includes, RefusalsSayWhatToWrite) {
  fs::create_directories(folder_ / "folder.toml");
  write("old.toml", "fps = 1");
  write("new.toml", "flatray = 2");
  write("bad.toml", "flatray = = 1");
  write("kinds.toml", "flatray = 1\nentity = 3");
  const Refused cases[] = {
      {"include = \"a.toml\"", "include is a string, not a list of file names"},
      {"include = [3]", "include[0] is a number, not a string"},
      {"include = [\"/etc/a.toml\"]", "'/etc/a.toml' is an absolute path"},
      {"include = [\"a.png\"]", "'a.png' has no extension of a scene\n"},
      {"include = [\"a.toml\"]", "file 'a.toml': cannot read: No such file"},
      {"include = [\"folder.toml\"]", "'folder.toml' is not a plain file"},
      {"include = [\"folder.toml\"]", "name a scene file to include"},
      {"include = [\"old.toml\"]", "old.toml:1:1: error: the included scene needs 'flatray'"},
      {"include = [\"new.toml\"]", "scene version 2 is newer than this program"},
      {"include = [\"bad.toml\"]", "bad.toml:1:11: error"},
      {"include = [\"kinds.toml\"]\n" + kNamedDisc + "\"e\"",
       "kinds.toml:2:10: error: entity is a number"},
      {"include = [\"main.toml\"]", "'main.toml' includes itself"},
      {"include = [\"../" + folder_.filename().string() + "/main.toml\"]", "includes itself"},
  };
  expect_refused(cases, [&](const std::string& text) {
    scene("main.toml", text);
    return refused();
  });
  EXPECT_NE(
      refusal("flatray = 1\n", {{"include", "[\"a.toml\"]"}}).find("include stands only in a file"),
      std::string::npos);
}

// From the folder of main.toml, whose names are those that other files may say of their own.
TEST_F(Includes, AnOutlineLiesBesideTheFileThatNamesIt) {
  fs::create_directory(folder_ / "sub");
  write("x.obj", "v 0 0\nv 1 0\nv 0 1\nf 1 2 3\n");
  write("sub/x.obj", "v 0 0\nv 9 0\nv 0 9\nf 1 2 3\n");
  scene("main.toml", "include = [\"x.obj\", \"sub/y.toml\"]\n");
  scene("sub/y.toml", "[[entity]]\nname = \"y\"\nshape = { import = { file = \"x.obj\" } }\n");
  const fs::path before = fs::current_path();
  fs::current_path(folder_);
  const Result<LoadedScene> made = load_scene("main.toml");
  fs::current_path(before);
  ASSERT_TRUE(made) << format(made.error());
  ASSERT_EQ(made->scene.shapes.size(), 2u);
  EXPECT_EQ(made->scene.shapes[0].vertices[1], Vec2(1, 0));
  EXPECT_EQ(made->scene.shapes[1].vertices[1], Vec2(9, 0));
}

TEST_F(Includes, E6ACircleOfFilesIsRefused) {
  scene("main.toml", "include = [\"a.toml\"]\n");
  scene("a.toml", "include = [\"b.toml\"]\n");
  scene("b.toml", "include = [\"a.toml\"]\n");
  EXPECT_EQ(refused(), R"(b.toml:2:12: error: 'a.toml' includes itself
    include = ["a.toml"]
               ^~~~~~~~  take this include out
    named at a.toml:2:12
    named at main.toml:2:12
)");
}

TEST_F(Includes, E6FilesThatIncludeTheNextTwiceAreReadOnce) {
  for (int i = 0; i < 30; ++i)
    scene("f" + std::to_string(i) + ".toml", "include = [\"f" + std::to_string(i + 1) +
                                                 ".toml\", \"./f" + std::to_string(i + 1) +
                                                 ".toml\"]\n");
  scene("f30.toml", kNamedDisc + "\"e\"");
  EXPECT_EQ(loaded("f0.toml").entities.size(), 1u);
}

TEST_F(Includes, LimitsNameTheirOptions) {
  scene("main.toml", "include = [\"f0.toml\"]\n");
  for (int i = 0; i < 80; ++i)
    scene("f" + std::to_string(i) + ".toml",
          "include = [\"f" + std::to_string(i + 1) + ".toml\"]\n");
  scene("f80.toml", "");
  EXPECT_NE(refused().find("f63.toml:2:12: error: files are included more than 64 deep\n"),
            std::string::npos)
      << refused();
  EXPECT_NE(refused().find("--max-depth raises the limit"), std::string::npos);
  LoadLimits limits;
  limits.max_depth = 81;
  EXPECT_EQ(refused(limits), "");
  limits.max_bytes = 100;
  EXPECT_NE(
      refused(limits).find("the limit of a scene and its files is 100; --max-bytes raises it"),
      std::string::npos)
      << refused(limits);
  limits.max_bytes = 10;
  EXPECT_NE(refused(limits).find("main.toml: error: is larger than 10 bytes\n    the limit of a "
                                 "scene and its files is 10; --max-bytes raises it"),
            std::string::npos)
      << refused(limits);
}

}  // namespace
}  // namespace flatray
