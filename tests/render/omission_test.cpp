// needs: shapes/box
// What a scene does not need is not done: by counts of work, not by what is said of it.
#include <gtest/gtest.h>

#include <algorithm>

#include "render/coverage_families.h"
#include "render/frame.h"
#include "support/pictures.h"

namespace flatray {
namespace {

using coverage_check::box_path;
using coverage_check::ring_path;

const std::string kFilm =
    "flatray = 1\nframes = 4\nfilm = { size = [64, 48], world = [[0, 0], [16, 12]] }\n";
const std::string kBoxScene =
    "[[entity]]\nname = \"box\"\nshape = { box = { min = [1, 1], max = [5, 4] } }\nat = [0, 0]\n";

// What asks for a pass, and all passes that run then.
struct Asks {
  const char* pass;
  std::string scene;
  std::vector<std::string> runs;
};
const std::vector<Asks> kAsks = {
    {"bounding_boxes",
     kBoxScene + "bounding_box = { width_px = 1, colour = \"#2c7a3f\" }\n",
     {"bounding_boxes", "entities"}},
    {"chambers", "[[chamber]]\nshape = { box = { min = [0, 0], max = [9, 9] } }\n", {"chambers"}},
    {"contacts",
     kBoxScene + "velocity = [1, 0]\n[collisions]\npoints = \"#ff0000\"\n",
     {"contacts", "entities"}},
    {"edge_rays",
     kBoxScene + "[[entity]]\nname = \"other\"\nshape = { box = { min = [7, 1], max = [9, 4] } }\n"
                 "[[edge_rays]]\nfrom = \"box\"\nagainst = \"other\"\n",
     {"edge_rays", "entities"}},
    {"entities", kBoxScene, {"entities"}},
    {"light", "[[lamp]]\nsource = { point = {} }\n", {"light"}},
    {"orbits", "[[ray]]\nat = [1, 1]\ndirection = [1, 0.5]\n", {"orbits"}}};

std::vector<std::string> names(const std::vector<const Pass*>& passes) {
  std::vector<std::string> all;
  for (const Pass* pass : passes) all.emplace_back(pass->name);
  return all;
}

std::string decision(const RenderPlan& plan, const std::string& part) {
  for (const RenderPlan::Choice& choice : plan.choices)
    if (choice.part == part) return choice.decision;
  return "not listed";
}

TEST(Omissions, AnEmptySceneRunsNoPass) {
  EXPECT_TRUE(make_plan(scene_of(kFilm), false).passes.empty());
}

TEST(Omissions, APassRunsWhereTheSceneAsksForItAndNowhereElse) {
  std::vector<std::string> asked;
  for (const Asks& one : kAsks) {
    asked.emplace_back(one.pass);
    EXPECT_EQ(names(make_plan(scene_of(kFilm + one.scene), false).passes), one.runs) << one.pass;
  }
  EXPECT_EQ(asked, names(passes())) << "a new pass has a row above";
}

TEST(Omissions, WhatThePlanListsIsWhatRuns) {
  for (const Asks& one : kAsks)
    for (const bool keep_all : {false, true}) {
      const RenderPlan plan = make_plan(scene_of(kFilm + one.scene), keep_all);
      const std::vector<std::string> runs = names(plan.passes);
      if (keep_all) {
        EXPECT_EQ(runs, names(passes()));
      }
      for (const Pass* pass : passes()) {
        const bool asked = std::count(one.runs.begin(), one.runs.end(), pass->name) > 0;
        EXPECT_EQ(decision(plan, std::string("pass ") + pass->name), asked      ? "kept"
                                                                     : keep_all ? "kept (asked)"
                                                                                : "left out");
      }
      EXPECT_EQ(decision(plan, "frames"), plan.still ? "drawn once" : "each drawn");
    }
}

// A pass that is not needed adds nothing to what is drawn.
TEST(Omissions, APassLeftOutHasNothingToDraw) {
  for (const Asks& one : kAsks) {
    const Scene scene = scene_of(kFilm + one.scene);
    const Timeline timeline(scene, 0, 4);
    EXPECT_EQ(draw_list(make_plan(scene, false), timeline, 2)->items.size(),
              draw_list(make_plan(scene, true), timeline, 2)->items.size())
        << one.pass;
  }
}

TEST(Omissions, AllFramesAreOnePictureWhereNothingMovesAndNowhereElse) {
  const auto plan = [](const std::string& more, bool keep_all = false) {
    return make_plan(scene_of(kFilm + kBoxScene + more), keep_all);
  };
  EXPECT_TRUE(plan("").still);
  EXPECT_EQ(decision(plan(""), "frames"), "drawn once");
  EXPECT_FALSE(plan("", true).still);
  for (const std::string moves :
       {"velocity = [0, 0.25]", "angular_velocity = 1", "opacity = { keys = [[0, 0], [1, 1]] }",
        "fill = { keys = [[0, \"#000000\"], [1, \"#ffffff\"]] }",
        "group = \"g\"\n[[group]]\nname = \"g\"\nvelocity = [1, 0]",
        "[camera]\nvelocity = [1, 0]"}) {
    EXPECT_FALSE(plan(moves).still) << moves;
    EXPECT_EQ(decision(plan(moves), "frames"), "each drawn") << moves;
  }
}

TEST(Omissions, WhatLiesBesideTheFilmIsNotDrawn) {
  const std::string box = kBoxScene.substr(0, kBoxScene.find("at ="));
  const auto at = [&](const std::string& place) {
    const Scene scene = scene_of(kFilm + box + "at = " + place + "\n");
    return draw_list(make_plan(scene, false), Timeline(scene, 0, 1), 1)->items.size();
  };
  EXPECT_EQ(at("[0, 0]"), 1U);
  EXPECT_EQ(at("[14, 0]"), 1U) << "one world unit of it shows";
  for (const char* beside : {"[17, 0]", "[-7, 0]", "[0, 13]", "[0, -6]"})
    EXPECT_EQ(at(beside), 0U) << beside;
}

// A film of one band: ten discs, then an opaque box over all of it, then a small disc.
DrawList hiding_list(Coverage coverage, float alpha) {
  DrawList list{128, 32, {1, 1, 1, 1}, coverage, {}};
  for (int i = 0; i < 10; ++i)
    list.items.push_back({FillRing{{12.0 * i, 16}, 9}, {0.1F, 0.2F, 0.3F, alpha}});
  list.items.push_back({box_path(-1, -1, 129, 33), {0, 0.5F, 0, 1}});
  list.items.push_back({FillRing{{60, 16}, 9.5}, {1, 0, 0, alpha}});
  return list;
}

template <class Picture>
std::uint64_t scans(const DrawList& list, bool keep_all = false) {
  FrameDrawer<Picture> drawer({std::nullopt, 1, keep_all});
  drawer.draw(list);
  EXPECT_EQ(drawer.counts().items, list.items.size());
  EXPECT_EQ(drawer.counts().hidden_items, keep_all ? 0U : 10U);
  return drawer.counts().scans;
}

// The disc and the box alone.
TEST(Omissions, WhatIsHiddenIsNotScanned) {
  for (const Coverage coverage : {Coverage::area, Coverage::rows, Coverage::centre})
    for (const float alpha : {1.0F, 0.5F}) {
      const DrawList list = hiding_list(coverage, alpha);
      EXPECT_EQ(scans<Image>(list), 2U);
      EXPECT_EQ(scans<LinearImage>(list), 2U);
      EXPECT_EQ(scans<Image>(list, true), 12U);
    }
  DrawList layered = hiding_list(Coverage::area, 1);
  layered.items.back().layer = 1, layered.items.back().opacity = 0.5F;
  EXPECT_EQ(scans<Image>(layered), 2U) << "a layer above";
}

TEST(Omissions, BandsThatShowWhatTheyShowedAreNotScanned) {
  DrawList list{1000, 640, {1, 1, 1, 1}, Coverage::area, {}};
  for (int i = 0; i < 20; ++i)
    list.items.push_back({box_path(10, 32 * i + 4, 20, 32 * i + 9), {0, 0, 1, 1}});
  FrameDrawer<Image> drawer({});
  drawer.draw(list);
  EXPECT_EQ(drawer.counts().scans, 20U) << "one in each band";
  std::get<FillPath>(list.items[3].region) = box_path(11, 100, 21, 105);
  drawer.draw(list);
  EXPECT_EQ(drawer.counts().scans, 21U);
  drawer.draw(list);
  EXPECT_EQ(drawer.counts().scans, 21U);
}

TEST(Omissions, WhatIsClearOrBesideThePictureIsNotScanned) {
  DrawList list{128, 32, {1, 1, 1, 1}, Coverage::area, {}};
  list.items.push_back({box_path(10, 4, 20, 9), {0, 0, 1, 0}});
  list.items.push_back({box_path(130, 4, 140, 9), {0, 0, 1, 1}});
  list.items.push_back({box_path(10, -9, 20, -1), {0, 0, 1, 1}});
  FrameDrawer<Image> drawer({});
  drawer.draw(list);
  EXPECT_EQ(drawer.counts().items, 0U);
  EXPECT_EQ(drawer.counts().scans, 0U);
}

// A path that goes up and down, of as many edges as asked for.
FillPath comb(int edges) {
  std::vector<Vec2> corners;
  for (int i = 0; i + 1 < edges; ++i) corners.emplace_back(2.0 * i, i % 2 == 0 ? 0.0 : 600.0);
  corners.emplace_back(1, -3);
  return ring_path(corners, false);
}

TEST(Omissions, EdgesAreSortedByBandOnlyWhereTheyAreMany) {
  for (const int edges : {47, 48, 49, 60}) {
    DrawList list{200, 640, {1, 1, 1, 1}, Coverage::area, {}};
    list.items.push_back({comb(edges), {0, 0, 1, 1}});
    const Bands bands(list, {0, 0, 200, 640});
    Band band;
    bands.list(0, band);
    ASSERT_EQ(band.size(), 1U);
    EXPECT_EQ(band[0].edges, edges > 48 ? static_cast<unsigned>(edges) : 0U) << edges;
  }
}

TEST(Omissions, APictureThatIsOpaqueHasNoFourthChannel) {
  DrawList list{16, 16, {1, 1, 1, 1}, Coverage::area, {}};
  EXPECT_EQ(render_image(list, {}).channels, 3);
  list.background.a = 0.5F;
  EXPECT_EQ(render_image(list, {}).channels, 4);
}

TEST(Omissions, HowManyRespondInWhichWayIsListed) {
  const std::string box = "[[entity]]\nshape = { box = { min = [0, 0], max = [1, 1] } }\n";
  const auto reason = [&](const std::string& text) {
    for (const RenderPlan::Choice& choice : make_plan(scene_of(kFilm + text), false).choices)
      if (choice.part == "responses") return choice.reason;
    return std::string("not listed");
  };
  EXPECT_EQ(reason(box), "nothing responds to contact");
  EXPECT_EQ(reason(box + "response = 'mark'\n" + box + "response = 'bounce'\nat = [3, 0]\n" + box +
                   "response = 'mark'\nat = [6, 0]\n" + box),
            "2 mark, 1 bounce");
}

}  // namespace
}  // namespace flatray
