// needs: shapes/arc shapes/box shapes/circle shapes/segment
#include "study/stability/pair_truth.h"

#include "collide/meetings.h"
#include "scene/scene_text.h"
#include "study/texts.h"

namespace flatray {
namespace {

using Pair = PairTruth::Pair;

// Two frames a second apart: what moves by 10 does so at once.
Scene scene_of(const std::string& entities) {
  return loaded("flatray = 1\nfps = 1\nframes = 2\n" + entities).scene;
}
std::string disc(double x, double y, double radius, const std::string& more = "") {
  return "[[entity]]\nshape = { circle = { radius = " + std::to_string(radius) + " } }\nat = [" +
         std::to_string(x) + ", " + std::to_string(y) + "]\n" + more;
}
PairTruth truth_of(const Scene& scene) {
  return pair_truth(Timeline(scene, 1, scene.frames), scene.frames, 1e6);
}

TEST(PairTruth, TellsOfDiscsThatMeetOnTheirWayAlone) {
  // At the same height, a little more apart than the radii are long, and beyond the end.
  const PairTruth truth =
      truth_of(scene_of(disc(0, 0, 1, "velocity = [10, 0]\n") + disc(5, 1.999, 1) +
                        disc(5, -2.001, 1) + disc(12.1, 0, 1)));
  EXPECT_EQ(truth.bent, 3U);
  EXPECT_EQ(truth.meet, (std::set<Pair>{{0, 1}}));
  EXPECT_EQ(truth.compared, (std::set<Pair>{{0, 1}, {0, 2}, {0, 3}}));
  EXPECT_TRUE(truth.words().starts_with("3 pairs with discs")) << truth.words();
  EXPECT_TRUE(truth_of(scene_of(disc(0, 0, 1, "velocity = [10, 0]\n") + disc(5, 1, 1)))
                  .words()
                  .starts_with("1 pair with discs"));
}

TEST(PairTruth, DoesNotTellWhatOnlyJustTouches) {
  const PairTruth truth = truth_of(scene_of(disc(0, 0, 1, "velocity = [10, 0]\n") + disc(5, 2, 1)));
  EXPECT_EQ(truth.grazing, 1U);
  EXPECT_TRUE(truth.compared.empty());
  EXPECT_TRUE(testing::has(truth.words(), "1 graze too closely to be told"));
}

TEST(PairTruth, FollowsWhatTurnsBetweenFrames) {
  // A bar of length 8 makes a quarter of a turn: it sweeps over one disc and ends short of another.
  const PairTruth truth =
      truth_of(scene_of("[[entity]]\nshape = { box = { min = [0, -0.1], max = [8, 0.1] } }\n"
                        "angular_velocity = 90\n" +
                        disc(5, 5, 0.5) + disc(-1, 5, 0.5) + disc(6.5, 6.5, 0.5)));
  EXPECT_EQ(truth.meet, (std::set<Pair>{{0, 1}}));
  EXPECT_EQ(truth.compared.size(), 3U);
}

// A tip that goes round once from frame to frame, so that no chord goes anywhere; and one that smooth
// keys send to a disc and back.
TEST(PairTruth, FollowsWhatIsCarriedBetweenFrames) {
  const PairTruth truth = truth_of(scene_of("[[group]]\nname = \"arm\"\nangular_velocity = 360\n" +
                                            disc(10, 0, 0.5, "group = \"arm\"\n") +
                                            disc(0, 10, 0.5) + disc(0, 8.9, 0.5)));
  EXPECT_EQ(truth.meet, (std::set<Pair>{{0, 1}}));
  EXPECT_EQ(truth.compared, (std::set<Pair>{{0, 1}, {0, 2}}));
  const PairTruth keys = truth_of(scene_of(
      "[[entity]]\nshape = { circle = { radius = 1 } }\nat = { keys = [[0, [0, 0]], [0.5, [5, 0]], "
      "[1, [0, 0]]], ease = \"smooth\" }\n" +
      disc(6.9, 0, 1) + disc(7.1, 0, 1)));
  EXPECT_EQ(keys.meet, (std::set<Pair>{{0, 1}}));
}

TEST(PairTruth, LeavesArcsOutAndSaysSo) {
  const PairTruth truth = truth_of(scene_of(
      disc(0, 0, 1, "velocity = [10, 0]\n") +
      "[[entity]]\nshape = { arc = { centre = [5, 0], radius = 1, from = 0, to = 90 } }\n"));
  EXPECT_EQ(truth.left_out, 1U);
  EXPECT_TRUE(truth.compared.empty());
}

// Discs and bars that move and turn as numbers have it, against what contact finds.
TEST(PairTruth, AgreesWithContactOnCrowds) {
  std::string text = "flatray = 1\nfps = 4\nframes = 9\n";
  for (int i = 0; i < 12; ++i) {
    const std::string at = "at = [" + std::to_string(1.5 * (i % 4)) + ", " +
                           std::to_string(1.3 * (i / 4)) + "]\nvelocity = [" +
                           std::to_string(0.7 * (i % 3) - 0.6) + ", " +
                           std::to_string(0.3 - 0.4 * (i % 5)) + "]\n";
    text += i % 2 == 0
                ? "[[entity]]\nshape = { circle = { radius = 0.4 } }\n" + at
                : "[[entity]]\nshape = { box = { min = [-0.5, -0.1], max = [0.5, 0.1] } }\n" + at +
                      "angular_velocity = " + std::to_string(40 * i) + "\n";
  }
  const Scene scene = loaded(text).scene;
  const PairTruth truth = truth_of(scene);
  EXPECT_EQ(truth.grazing, 0U);
  EXPECT_EQ(truth.compared.size(), 66U);
  EXPECT_GT(truth.meet.size(), 5U);
  EXPECT_LT(truth.meet.size(), 60U);
  std::set<Pair> found;
  const auto met = find_meetings(Timeline(scene, 1, scene.frames), scene.frames);
  for (const Meeting& meeting : met.value()) found.insert({meeting.a, meeting.b});
  EXPECT_EQ(found, truth.meet);
}

}  // namespace
}  // namespace flatray
