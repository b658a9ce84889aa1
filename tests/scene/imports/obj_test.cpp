// needs: shapes/import formats/obj
#include <gtest/gtest.h>

#include <filesystem>

#include "base/file.h"
#include "scene/imports/obj_text.h"
#include "scene/scene_text.h"
#include "support/own_folder.h"
#include "support/paths.h"

namespace flatray {
namespace {

Result<LoadedScene> load_obj(const std::string& text, const std::string& name = "dir/part.obj") {
  return load_scene_text(name, text);
}

Shape outline(const std::string& text) {
  const Result<LoadedScene> scene = load_obj(text);
  FLATRAY_CHECK(scene.has_value(), scene ? "" : format(scene.error()));
  return scene->scene.shapes.at(0);
}

std::string obj_refusal(const std::string& text) {
  const Result<LoadedScene> scene = load_obj(text);
  return scene ? "" : format(scene.error());
}

constexpr const char* kSquare = "v 0 0 5\nv 2 0 5\nv 2 2 -1\nv 0 2 1e3\n";

TEST(Obj, IsASceneOfOneEntityNamedAfterTheFile) {
  const Result<LoadedScene> scene = load_obj(std::string(kSquare) + "f 1 2 3\n");
  ASSERT_TRUE(scene) << format(scene.error());
  EXPECT_EQ(scene->scene.name, "part");
  ASSERT_EQ(scene->scene.entities.size(), 1u);
  EXPECT_EQ(scene->scene.entities[0].name, "part");
  EXPECT_EQ(*scene->scene.entities[0].fill, (Colour{0x33, 0x33, 0x33, 255}));
  EXPECT_EQ(scene->scene.film.width, 640);
  EXPECT_TRUE(scene->warnings.empty());
}

TEST(Obj, ReadsEveryFormOfAFace) {
  const std::vector<Vec2> square = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  for (const char* face : {"f 1 2 3 4", "f 1/1 2/2 3/3 4/4", "f 1/1/1 2/2/2 3/3/3 4/4/4",
                           "f 1//1 2//1 3//1 4//1", "f -4 -3 -2 -1", "  f\t1 2  3 4 # all",
                           "f 1 2 \\\n 3 4", "f 1 2 \\\r\n3 4\r\n", "f 1 2\\\n3 4"}) {
    const Shape shape = outline(std::string(kSquare) + face);
    EXPECT_EQ(shape.vertices, square) << face;
    EXPECT_EQ(shape.edges, (std::vector<std::int32_t>{0, 1, 2, 3})) << face;
  }
}

TEST(Obj, FacesMayComeBeforeTheirVertices) {
  EXPECT_EQ(outline(std::string("f 1 2 3\n") + kSquare).piece_count(), 1u);
}

TEST(Obj, ClockwiseFacesAreTurned) {
  const Shape shape = outline(std::string(kSquare) + "f 3 2 1\n");
  EXPECT_EQ(shape.vertices, (std::vector<Vec2>{{2, 2}, {0, 0}, {2, 0}}));
  EXPECT_EQ(shape.edges, (std::vector<std::int32_t>{2, 1, 0}));
}

TEST(Obj, EdgesAreNumberedThroughAllFaces) {
  const Shape shape = outline(std::string(kSquare) + "f 1 2 3\nf 1 3 4\n");
  EXPECT_EQ(shape.edges, (std::vector<std::int32_t>{0, 1, 2, 3, 4, 5}));
}

TEST(Obj, FacesThatAreNotConvexAreCut) {
  const Shape shape = outline("v 0 0\nv 4 0\nv 4 4\nv 2 1\nv 0 4\nf 1 2 3 4 5\n");
  EXPECT_GE(shape.piece_count(), 2u);
}

TEST(Obj, FacesWithoutAreaAndCrossingOnesAreCounted) {
  const Result<LoadedScene> scene =
      load_obj(std::string(kSquare) + "v 1 1\nf 1 2 3\nf 1 3 5\nf 1 1 2\nf 1 3 5 1\nf 1 3 2 4\n");
  ASSERT_TRUE(scene);
  EXPECT_EQ(scene->scene.shapes[0].piece_count(), 1u);
  ASSERT_EQ(scene->warnings.size(), 2u);
  EXPECT_EQ(scene->warnings[0].message, "3 faces without area left out; this is the first");
  EXPECT_EQ(scene->warnings[1].message, "1 face left out because of edges that cross");
  for (int i : {0, 1}) {
    const Place& where = scene->warnings[static_cast<std::size_t>(i)].where;
    EXPECT_EQ(where.source->position(where.offset).line, i == 0 ? 7 : 10);
  }
}

TEST(Obj, AVertexTooFarAwayIsShownInItsLine) {
  EXPECT_EQ(obj_refusal("v 0 0\nv 1 \\\n0\nv 0 1e301\nf 1 2 3\n"),
            R"(dir/part.obj:4:1: error: this vertex comes to lie beyond 1e300
    v 0 1e301
    ^  choose a smaller scale
)");
}

TEST(Obj, PolylinesAreSegments) {
  const Shape shape = outline(std::string(kSquare) + "l 1 2 3\nl 3/1 4/2\n");
  ASSERT_EQ(shape.segments.size(), 3u);
  EXPECT_EQ(shape.segments[2].a, Vec2(2, 2));
  EXPECT_EQ(shape.segments[2].b, Vec2(0, 2));
}

TEST(Obj, OtherRecordsAreNamedOnce) {
  const Result<LoadedScene> scene = load_obj("# by hand\nmtllib a.mtl\nvt 0 0\nvn 0 0 1\nvt 1 1\n" +
                                             std::string(kSquare) + "usemtl b\nf 1 2 3\n");
  ASSERT_TRUE(scene);
  ASSERT_EQ(scene->warnings.size(), 1u);
  EXPECT_EQ(scene->warnings[0].message, "mtllib, vt, vn, usemtl ignored");
}

TEST(Obj, RecordsPassedOverAreContinuedAndTheirCommentsAreNot) {
  for (const char* record : {"o tri # a comment \\\n", "o # \\\r\n", "o tri \\\nv 9 9 # \\\n",
                             "# one \\\no tri # two \\\n", "usemtl a#b\\\n", "o\\\n#\\\n"})
    EXPECT_EQ(outline(record + std::string(kSquare) + "f 1 2 3\n").vertices,
              (std::vector<Vec2>{{0, 0}, {2, 0}, {2, 2}}))
        << record;
}

TEST(Obj, TwoDimensionalFilesCountFromZero) {
  for (const char* name : {"a.obj2d", "A.OBJ2D", "dir.x/a.Obj2d"}) {
    const auto scene = load_obj("v 0 0\nv 1 0\nv 0 1\nf 0 1 2\n", name);
    ASSERT_TRUE(scene) << format(scene.error());
    EXPECT_EQ(scene->scene.shapes[0].vertices[0], Vec2(0, 0));
    EXPECT_FALSE(load_obj("v 0 0\nv 1 0\nv 0 1\nf 1 2 3\n", name));
  }
}

TEST(Obj, MistakesHaveALineAndAColumn) {
  const Refused cases[] = {
      {"v 0 0\nv 1 x 0\n", "dir/part.obj:2:5: error: 'x' is not a finite number"},
      {"v 0 nan\n", "dir/part.obj:1:5: error: 'nan' is not a finite number"},
      {"v 0 1e400\n", "1:5: error: '1e400' is not a finite number"},
      {"v 0 1,5\n", "1:5: error: '1,5' is not a finite number"},
      {"v 0\n", "1:1: error: a vertex has no x and y"},
      {"v 1 2 3 4 5 6 7 8\n", "1:17: error: a vertex has too many numbers"},
      {"f 1 2\n", "1:1: error: 'f' needs at least 3 vertices"},
      {"l 1\n", "1:1: error: 'l' needs at least 2 vertices"},
      {"v 0 0\nv 1 0\nv 0 1\nf 1 2 0\n", "4:7: error: '0' is not a vertex number"},
      {"v 0 0\nv 1 0\nv 0 1\nf 1 2 4\n", "4:7: error: there is no such vertex"},
      {"v 0 0\nv 1 0\nv 0 1\nf 1 2 -4\n", "4:7: error: there is no such vertex"},
      {"v 0 0\nf 1 1/x 1\n", "2:5: error: '1/x' is not a vertex number"},
      {"v 0 0\nf 1 1/ 1\n", "2:5: error: '1/' is not a vertex number"},
      {"v 0 0\nf 1 1// 1\n", "2:5: error: '1//' is not a vertex number"},
      {"v 0 0\nf 1 1/1/1/1 1\n", "2:5: error: '1/1/1/1' is not a vertex number"},
      {"v 0 0\nf 1 99999999999999999999 1\n",
       "2:5: error: '99999999999999999999' is not a vertex number"},
      {"", "the file holds no face or line"},
      {"v 0 0\n", "the file holds no face or line"},
  };
  expect_refused(cases, obj_refusal);
}

TEST(Obj, AVertexThatIsWrongKeepsItsNumber) {
  const auto scene = load_obj("v 0 0\nv 1 x\nv 0 1\nv 1 1\nf 1 3 4\n");
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().size(), 1u) << format(scene.error());
}

TEST(Obj, AtMostTwentyMistakesAreTold) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += "v x y\n";
  const Result<LoadedScene> scene = load_obj(text);
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().size(), 20u);
}

using ImportedFile = OwnFolder;

TEST_F(ImportedFile, IsRelativeToTheSceneScaledAndCentred) {
  ASSERT_TRUE(write_file(folder_ / "part.obj", "v 1 1\nv 3 1\nv 3 5\nv 1 5\nf 1 2 3 4\n"));
  const std::string text = with_shape("import = { file = \"part.obj\", scale = 2, centre = true }");
  const auto scene = load_scene_text((folder_ / "s.toml").string(), text);
  ASSERT_TRUE(scene) << format(scene.error());
  EXPECT_EQ(scene->scene.shapes[0].vertices,
            (std::vector<Vec2>{{-2, -4}, {2, -4}, {2, 4}, {-2, 4}}));
  ASSERT_TRUE(write_file(folder_ / "part.obj", "v 1 1\nv 3 1\nv 3 5\nv 1 6\nf 1 2 3 4\n"));
  EXPECT_NE(load_scene_text((folder_ / "s.toml").string(), text)->scene.hash, scene->scene.hash);
}

TEST_F(ImportedFile, MayBeginWithAByteOrderMark) {
  ASSERT_TRUE(write_file(folder_ / "part.obj", "\xef\xbb\xbfv 1 1\nv 3 1\nv 3 5\nf 1 2 3\n"));
  const auto scene = load_scene_text((folder_ / "s.toml").string(),
                                     with_shape("import = { file = \"part.obj\" }"));
  ASSERT_TRUE(scene) << format(scene.error());
  EXPECT_EQ(scene->scene.shapes[0].vertices, (std::vector<Vec2>{{1, 1}, {3, 1}, {3, 5}}));
  EXPECT_TRUE(scene->warnings.empty());
}

TEST_F(ImportedFile, IsCentredByTheCornersOfItsFacesAndLines) {
  const std::string text = with_shape("import = { file = \"part.obj\", centre = true }");
  const auto first_vertex = [&](const std::string& records) {
    EXPECT_TRUE(write_file(folder_ / "part.obj", "v 9 9\nv 1 1\nv 3 1\nv 3 5\nv 1 9\n" + records));
    return load_scene_text((folder_ / "s.toml").string(), text)->scene.shapes[0].vertices[0];
  };
  EXPECT_EQ(first_vertex("f 2 3 4\n"), Vec2(-1, -2));
  EXPECT_EQ(first_vertex("f 2 3 4\nl 4 5\n"), Vec2(-1, -4));
  EXPECT_EQ(first_vertex("f 2 3 4\nf 1 1 1\n"), Vec2(-4, -4));
}

TEST(Import, MistakesAreTold) {
  EXPECT_NE(refusal(with_shape("import = { file = \"none.obj\" }"))
                .find("4:29: error: file 'none.obj': cannot read: No such file"),
            std::string::npos);
  EXPECT_EQ(load(with_shape("import = { file = \"none.obj\" }")).error()[0].trouble,
            Trouble::missing);
  EXPECT_NE(
      refusal(with_shape("import = { file = \"t.toml\" }")).find("'t.toml' is not an outline"),
      std::string::npos);
  EXPECT_NE(refusal(with_shape("import = { file = \"a\", format = \"svg\" }"))
                .find("'svg' is not an outline"),
            std::string::npos);
  EXPECT_NE(refusal(with_shape("import = { file = \"a.obj\", scale = 0 }")).find("a scale of 0"),
            std::string::npos);
  EXPECT_NE(
      refusal(with_shape("import = { file = \"a\\u0000.obj\" }")).find("this is not a file name"),
      std::string::npos);
}

std::filesystem::path shared_obj(const char* name) {
  return std::filesystem::path(source_path()) / "../shared/data/obj" / name;
}

struct Known {
  const char* file;
  std::size_t faces;
};

TEST(ObjFiles, ThoseOfOthersAreReadWhole) {
  if (!std::filesystem::exists(shared_obj("woody.obj"))) GTEST_SKIP() << "shared/data is absent";
  const Known files[] = {{"woody.obj", 1267},    {"armadillo.obj2d", 138},
                         {"bunny.obj2d", 137},   {"donut.obj2d", 184},
                         {"terrain.obj2d", 200}, {"stanford-bunny.obj", 69449}};
  for (const auto& [file, faces] : files) {
    const Result<LoadedScene> scene = load_scene(shared_obj(file));
    ASSERT_TRUE(scene) << format(scene.error());
    EXPECT_EQ(scene->scene.shapes[0].piece_count(), faces) << file;
  }
}

// 69 451 triangles, of which two have no area once z is dropped.
TEST(ObjFiles, FacesWithoutAreaAreCounted) {
  if (!std::filesystem::exists(shared_obj("stanford-bunny.obj")))
    GTEST_SKIP() << "shared/data is absent";
  const Result<LoadedScene> scene = load_scene(shared_obj("stanford-bunny.obj"));
  ASSERT_TRUE(scene);
  ASSERT_EQ(scene->warnings.size(), 1u);
  EXPECT_EQ(scene->warnings[0].message, "2 faces without area left out; this is the first");
}

}  // namespace
}  // namespace flatray
