// needs: shapes/circle shapes/box shapes/segment
#include "render/view.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "seen.h"

namespace flatray {
namespace {

// A window of 8 x 4 world units on 8 x 4 pixels: a box from x = 4 to 6 over the lower half.
const char* const kViewedBox = R"(flatray = 1
film = { size = [8, 4], world = [[0, 0], [8, 4]] }
[[entity]]
shape = { box = { min = [4, 0], max = [6, 2] } }
fill = "#000000"
)";

std::vector<int> row(const Image& image, int y) {
  std::vector<int> values;
  for (int x = 0; x < image.width; ++x) values.push_back(image.at(x, y)[0]);
  return values;
}

// From the centre of pixel 0 the box is 3.5 pixels away, of 8; inside it the far side is met.
TEST(View, DepthIsTheDistanceToTheFirstWallOnTheRight) {
  const Image depth = view_of(scene_of(kViewedBox), "depth");
  EXPECT_EQ(row(depth, 0), std::vector<int>(8, 0));
  const auto grey = [](double t) { return static_cast<int>(std::lround(255 * (1 - t / 8))); };
  EXPECT_EQ(row(depth, 3), (std::vector<int>{grey(3.5), grey(2.5), grey(1.5), grey(0.5), grey(1.5),
                                             grey(0.5), 0, 0}));
}

TEST(View, IntervalsAreTheLengthInsideAheadAndOverlapsCountOnce) {
  const auto grey = [](double t) { return static_cast<int>(std::lround(255 * (1 - t / 8))); };
  const std::vector<int> wanted = {grey(2),   grey(2),   grey(2), grey(2),
                                   grey(1.5), grey(0.5), 255,     255};
  EXPECT_EQ(row(view_of(scene_of(kViewedBox), "intervals"), 3), wanted);
  const std::string twice = fmt::format("{}{}", kViewedBox, R"([[entity]]
shape = { box = { min = [5, 0], max = [6, 2] } }
)");
  EXPECT_EQ(row(view_of(scene_of(twice), "intervals"), 3), wanted);
}

TEST(View, ALightBehindTheBoxDoesNotReachItsOtherSide) {
  const Image lit = view_of(scene_of(kViewedBox), "visibility", {7.5, 0.5});
  EXPECT_EQ(row(lit, 3), (std::vector<int>{64, 64, 64, 64, 64, 64, 255, 255}));
  EXPECT_EQ(row(lit, 0)[7], 255);
}

// The top of a box is y = 1 for |x| <= 3: from a point on it, all is lit but what lies behind the
// bottom and the sides, y < -1 and |x| > 3 below the top. A third is no double: 0.3 lies between.
TEST(View, APointOnAWallLightsBothItsSides) {
  expect_lit(R"(flatray = 1
film = { size = [80, 80], world = [[-4, -4], [4, 4]] }
[[entity]]
shape = { box = { min = [-3, -1], max = [3, 1] } }
)",
             {0.3, 1}, [](const Vec2& p) {
               return p.y() >= 1 || (p.y() >= -1 && p.x() >= -3 && p.x() <= 3);
             });
}

// Of a picture that lies in a box all is dark, however far away the point is; right of the box nothing is
// where the point is far to the right.
TEST(View, APointFarAwayDoesNotShineThroughWalls) {
  const auto box = [](const char* high) {
    return fmt::format(R"(flatray = 1
film = {{ size = [80, 80], world = [[-4, -4], [4, 4]] }}
[[entity]]
shape = {{ box = {{ min = [-5, -5], max = {} }} }}
)",
                       high);
  };
  for (const double far : {1e6, 1e15, 1e17, 1e30, 1e200}) {
    expect_lit(box("[5, 5]"), {far, 2}, [](const Vec2&) { return false; });
    expect_lit(box("[1, 5]"), {far, 2}, [](const Vec2& p) { return p.x() >= 1; });
    // A pixel whose centre is on a wall, behind another.
    expect_lit(box("[1.05, 5]") +
                   "[[entity]]\nshape = { segment = { from = [0.05, -4], to = [0.05, 4] } }\n"
                   "stroke = { width = 1, colour = \"#000000\" }\n",
               {far, 2}, [](const Vec2& p) { return p.x() >= 1.05; });
  }
}

// On a slanted wall rays from the pixels to the point end short of it or beyond by rounding, in
// stripes.
TEST(View, APointOnASlantedWallCastsNoStripes) {
  expect_lit(R"(flatray = 1
film = { size = [101, 101], world = [[-4, -4], [4, 4]] }
[[entity]]
shape = { segment = { from = [-3, -1], to = [3, 2] } }
stroke = { width = 0.1, colour = "#000000" }
)",
             {1, 1}, [](const Vec2&) { return true; });
}

TEST(View, APointOnARimLightsTheDiscAndItsOwnHalfPlane) {
  expect_lit(R"(flatray = 1
film = { size = [81, 81], world = [[-4, -4], [4, 4]] }
[[entity]]
shape = { circle = { radius = 1.25 } }
)",
             {0.75, 1}, [](const Vec2& p) {
               return p.squaredNorm() <= 1.25 * 1.25 || 0.75 * p.x() + p.y() >= 1.25 * 1.25;
             });
}

TEST(View, HitsHaveOneColourAnObject) {
  const std::string two = fmt::format("{}{}", kViewedBox, R"([[entity]]
shape = { circle = { centre = [2, 3], radius = 0.9 } }
)");
  const Image hits = view_of(scene_of(two), "hits");
  EXPECT_NE(row(hits, 0)[0], row(hits, 3)[0]);
  EXPECT_EQ(row(hits, 3)[0], row(hits, 3)[5]);
  EXPECT_EQ(row(hits, 3)[7], 255);
}

TEST(View, IsTheSameFromEveryExactTracerThreadsAndCrop) {
  const Scene scene = scene_at("scenes/tutorial/11_journey.toml", {{"film.size", "[64, 36]"}});
  FrameOptions threads, crop;
  threads.threads = 3;
  crop.crop = PixelBox{20, 10, 32, 16};
  for (const View* view : views()) {
    const Vec2 point(3, 4);
    const Image whole = view_of(scene, view->name, point);
    EXPECT_TRUE(has_content(whole)) << view->name;
    const Tracer* const brute = find_tracer("brute");
    EXPECT_EQ(whole, view_of(scene, view->name, point, brute, threads)) << view->name;
    const Image part = view_of(scene, view->name, point, brute, crop);
    for (int y = 0; y < part.height; ++y)
      EXPECT_TRUE(std::equal(part.at(0, y), part.at(0, y) + 3 * part.width, whole.at(20, 10 + y)));
    for (const Tracer* tracer : tracers()) {
      if (!tracer->exact) continue;
      EXPECT_EQ(whole, view_of(scene, view->name, point, tracer))
          << view->name << " by " << tracer->name;
    }
  }
}

}  // namespace
}  // namespace flatray
