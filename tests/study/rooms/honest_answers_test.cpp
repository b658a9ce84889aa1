// needs: shapes/box shapes/capsule shapes/circle shapes/ellipse shapes/sector experiments/mean-free-path experiments/recurrence experiments/splitting experiments/transport experiments/periodic
// Rooms and counts at which experiments once said more than they knew, or the wrong thing.
#include <gtest/gtest.h>

#include "study/chamber_scenes.h"
#include "study/statistics/estimate.h"

namespace flatray {
namespace {

using namespace flatray::testing;

// A part of a ring: pi A / P with A = 3 pi / 16 and P = 1 + 3 pi / 4, and nothing gets out: the room
// lies outside its inner arc.
TEST(HonestAnswers, RoomsWithHollowArcsAreOnTheRightSideOfThem) {
  const Scene scene = room("sector = { radius = 1, from = 0, to = 90, inner = 0.5 }");
  for (const OrbitPrecision precision : {OrbitPrecision::exact, OrbitPrecision::fast}) {
    const auto found =
        run("mean-free-path", {.scene = scene, .count = 100'000, .precision = precision});
    const Measure path = measure(found, "mean_free_path");
    EXPECT_NEAR(*path.expected, 0.5513836, 1e-6);
    EXPECT_TRUE(agrees(path)) << path.value;
    EXPECT_EQ(measure(found, "orbits_escaped").value, 0);
  }
}

TEST(HonestAnswers, PillarsWithHollowArcsAreMetFromOutside) {
  const Scene scene = room("circle = { centre = [0, 0], radius = 1 }",
                           "{ name = \"slice\", shape = { sector = { radius = 0.8, from = 0, to = "
                           "90, inner = 0.5 } } }");
  const auto found = run("mean-free-path", {.scene = scene, .count = 100'000});
  EXPECT_TRUE(agrees(measure(found, "mean_free_path"))) << measure(found, "mean_free_path").value;
  EXPECT_EQ(measure(found, "orbits_escaped").value, 0);
}

// Clones that do not part leave no orbit, which is no share of 0.
TEST(HonestAnswers, NoOrbitThatIsLeftIsNoShare) {
  const Scene scene = scene_of(three_discs_6_apart());
  const auto found =
      run("splitting", {.scene = scene, .count = 100'000, .precision = OrbitPrecision::fast});
  const Measure left = found.measures.front();
  EXPECT_FALSE(left.standard_error) << left.value;
  EXPECT_TRUE(has(left.remark, "a larger --apart"));
  for (const Measure& one : found.measures) EXPECT_GE(one.value, 0) << one.name;
}

// What is left in a circle falls like a power.
TEST(HonestAnswers, SplittingTellsNoRateWhereThereIsNone) {
  const Scene scene =
      with_holes("circle = { centre = [0, 0], radius = 1 }", "{ from = 0.1, to = 0.12 }");
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
    for (const Measure& one :
         run("splitting",
             {.scene = scene, .seed = seed, .count = 300'000, .precision = OrbitPrecision::fast})
             .measures)
      EXPECT_FALSE(has(one.name, "escape_rate")) << one.name << " " << one.value;
}

// Four triangles that touch in their corners seal a square off: it is of the walls, and no orbit comes out
// of it; P / h of the others is what returns take. Of an ellipse with a hole round the end of its long axis
// nothing comes to the hole that passes between the foci so far from the axis, 0.4808 of all; the others
// take 6.428 arrivals.
TEST(HonestAnswers, KacsLemmaIsOfWhatComesToTheHoles) {
  std::string triangles;
  for (const char* points : {"[1, 0], [1, 1], [0, 1]", "[0, 1], [-1, 1], [-1, 0]",
                             "[-1, 0], [-1, -1], [0, -1]", "[0, -1], [1, -1], [1, 0]"})
    triangles += "{ shape = { convex = { points = [" + std::string(points) + "] } } }, ";
  const Scene sealed =
      chamber_with("box = { min = [-2, -2], max = [2.3, 2.1] }",
                   "holes = [{ edge = 0, from = 0.2, to = 0.4 }]\npillars = [" + triangles + "]\n");
  const Scene ellipse = with_holes("ellipse = { radii = [3, 2] }", "{ from = 0.95, to = 1.05 }");
  for (const auto& [scene, arrivals] :
       {std::pair(&sealed, 24.8 / 0.86), std::pair(&ellipse, 6.428)}) {
    const auto found = run("recurrence", {.scene = *scene, .count = 10'000});
    EXPECT_TRUE(found.holds);
    const Measure mean = measure(found, "mean_arrivals");
    EXPECT_FALSE(mean.expected || measure(found, "mean_way").expected);
    EXPECT_TRUE(has(mean.remark, "of 2000 orbits from all walls did not come to a hole"));
    EXPECT_NEAR(mean.value / arrivals, 1, 0.04);
  }
}

// Half of that ellipse is closed: no level of bounces leaves a quarter.
TEST(HonestAnswers, SplittingSaysWhereARoomIsClosedInPart) {
  const Scene scene = with_holes("ellipse = { radii = [3, 2] }", "{ from = 0.95, to = 1.05 }");
  const auto refused =
      experiment("splitting").run({.scene = scene, .precision = OrbitPrecision::fast});
  ASSERT_FALSE(refused.has_value());
  EXPECT_TRUE(has(format(refused.error()), "of 2000 are still there after 2000 bounces"))
      << format(refused.error());
}

// What is hidden between walls that lie on one another counts in no perimeter, so that such rooms are
// refused; a pillar that touches a wall in a point hides nothing.
TEST(HonestAnswers, WallsThatLieOnOneAnotherAreRefused) {
  const std::string corner = "min = [0, 0], max = [1, 1]", box = "box = { " + corner + " }",
                    step = "{ shape = { box = { min = [0.4, 0], max = [0.6, 0.3] } } }",
                    on_step = "{ shape = { box = { min = [0.5, 0.3], max = [0.7, 0.6] } } }",
                    apart = "{ shape = { box = { min = [0.4, 0.1], max = [0.6, 0.3] } } }",
                    on_tip =
                        "{ shape = { convex = { points = [[0.5, 0], [0.6, 0.3], [0.4, 0.3]] } } }";
  const auto answer = [](const Scene& scene) {
    return experiment("mean-free-path").run({.scene = scene, .count = 20'000});
  };
  for (const Scene& scene :
       {room(box, step), room(box, apart + ", " + on_step),
        chamber_with(box, "material = \"periodic\"\npillars = [" + step + "]\n")}) {
    const auto refused = answer(scene);
    ASSERT_FALSE(refused.has_value());
    EXPECT_TRUE(has(format(refused.error()), "no orbit comes between them"))
        << format(refused.error());
  }
  const auto ring =
      answer(room("box = { min = [-2, -2], max = [2, 2] }",
                  "{ shape = { sector = { radius = 1.2, inner = 0.9, from = 0, to = 360 } } }"));
  ASSERT_FALSE(ring.has_value());
  EXPECT_TRUE(has(format(ring.error()), "a wall of pillar 1 lies on one of its own"))
      << format(ring.error());
  const std::string capsule = "capsule = { from = [-1, 0], to = [1, 0], radius = 1 }";
  // Half-diameters of an arc by degrees are turned, and their length rounded.
  std::vector<Scene> rooms{
      room(capsule, "{ shape = { circle = { centre = [1, 0], radius = 1 } } }")};
  for (int from = 0; from < 90; ++from)
    rooms.push_back(room("circle = { radius = 1.5 }",
                         "{ shape = { sector = { radius = 1.5, from = " + std::to_string(from) +
                             ", to = " + std::to_string(from + 50) + " } } }"));
  for (const Scene& scene : rooms) {
    const auto refused = answer(scene);
    ASSERT_FALSE(refused.has_value());
    const std::string why = format(refused.error());
    EXPECT_TRUE(has(why, "no orbit comes between them") ||
                has(why, "does not stand in the chamber"))
        << why;
  }
  for (int end = 10; end < 150; end += 7) {  // one after the other, and not on one another
    const auto arc = [](int from, int to) {
      return "{ shape = { arc = { radius = 1.5, from = " + std::to_string(from) +
             ", to = " + std::to_string(to) + " } } }";
    };
    const auto in_line =
        answer(room("circle = { radius = 3 }", arc(1, end) + ", " + arc(end, 160)));
    EXPECT_TRUE(in_line.has_value()) << end;
  }
  const auto touching = answer(room(box, on_tip));
  ASSERT_TRUE(touching.has_value()) << format(touching.error());
  EXPECT_TRUE(agrees(measure(*touching, "mean_free_path")));
  EXPECT_EQ(measure(*touching, "orbits_into_corners").value, 0);
}

// The seam of a ring that is the chamber itself is two walls on one another: what comes to it ends.
TEST(HonestAnswers, MeanFreePathSaysWhereOrbitsEndInCorners) {
  const Scene scene = room("sector = { radius = 2, inner = 1, from = 0, to = 360 }");
  const Measure path =
      measure(run("mean-free-path", {.scene = scene, .count = 20'000}), "mean_free_path");
  EXPECT_FALSE(path.standard_error);
  EXPECT_TRUE(has(path.remark, "of 200 orbits ended in corners")) << path.remark;
}

// Of so few orbits it cannot be told whether flights have a variance.
TEST(HonestAnswers, TransportOfFewOrbitsIsUndecided) {
  const Scene scene = torus("0.35");
  const auto found = run("transport", {.scene = scene, .count = 1000, .bounces = 128});
  EXPECT_TRUE(has(found.summary, "undecided"));
  EXPECT_FALSE(measure(found, "diffusion_einstein").standard_error);
}

// Cubes of such lengths, or their squares, too, are beyond the doubles: in their place stand no NaNs.
TEST(HonestAnswers, HugeAndTinyRoomsHaveIntervalsOrSayWhyNot) {
  for (const char* size : {"1e145", "1e-145", "1e150"}) {
    const Scene scene =
        room(std::string("box = { min = [0, 0], max = [") + size + ", " + size + "] }");
    const auto found = run("mean-free-path", {.scene = scene, .count = 4000});
    const Measure path = measure(found, "mean_free_path");
    EXPECT_TRUE(agrees(path));
    EXPECT_NEAR(path.value / *path.expected, 1, 0.1);
    EXPECT_EQ(path.standard_error.has_value(), path.remark.empty()) << path.remark;
    if (path.standard_error) {
      EXPECT_LT(interval(path)->high - interval(path)->low, 0.2 * path.value);
    } else {
      EXPECT_TRUE(has(path.remark, "beyond the doubles"));
    }
  }
}

TEST(HonestAnswers, PillarsThatOverlapAreToldByTheirPlace) {
  const Scene scene = room("box = { min = [0, 0], max = [1, 1] }",
                           "{ shape = { circle = { centre = [0.3, 0.5], radius = 0.25 } } }, "
                           "{ shape = { circle = { centre = [0.7, 0.5], radius = 0.25 } } }");
  for (const char* name : {"periodic", "mean-free-path"}) {
    const auto refused = experiment(name).run({scene});
    ASSERT_FALSE(refused.has_value());
    EXPECT_TRUE(has(format(refused.error()), "a pillar overlaps a pillar"));
    EXPECT_TRUE(has(format(refused.error()), "room.toml:"));
  }
}

}  // namespace
}  // namespace flatray
