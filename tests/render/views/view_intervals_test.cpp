// The view `intervals` against every part clipped to the ray of every pixel.
// needs: shapes/arc shapes/box shapes/capsule shapes/circle shapes/convex shapes/ellipse shapes/import shapes/mushroom shapes/ngon shapes/penrose shapes/polygon shapes/polyline shapes/sector shapes/segment shapes/star shapes/text shapes/tokarsky formats/toml formats/obj formats/list tracers/brute tracers/grid tracers/exact
#include <gtest/gtest.h>

#include "geom/clip.h"
#include "geom/curved_path.h"
#include "geom/interval_set.h"
#include "render/counting_tracer.h"
#include "render/row_lengths.h"
#include "seen.h"

namespace flatray {
namespace {

// By the tracer of choice where none is given.
Image intervals_of(const Scene& scene, const Tracer* tracer = nullptr) {
  return view_of(scene, "intervals", {0, 0}, tracer);
}

void add(const HitInterval& hit, std::vector<Range>& inside) {
  if (hit) inside.push_back({hit.t_enter, hit.t_exit});
}

void add_shape(const Shape& shape, const Pose& place, const Ray& ray, std::vector<Range>& inside) {
  for (std::size_t piece = 0; piece < shape.piece_count(); ++piece)
    add(clip_convex(ray, posed_piece(shape, piece, place)), inside);
  for (const Circle& circle : shape.circles) add(clip_circle(ray, posed(circle, place)), inside);
  for (const ArcPath& path : shape.arc_paths)
    if (path.closed)
      for (const HitInterval& hit : clip_path(ray, path_in_world(path, place))) add(hit, inside);
}

double length_ahead(const Scene& scene, const FrameState& state, const Ray& ray) {
  std::vector<Range> inside;
  for (std::size_t i = 0; i < scene.entities.size(); ++i)
    if (!state.entities[i].gone)
      add_shape(shape_of(scene, state.entities[i]), entity_pose(state, i), ray, inside);
  for (const Chamber& chamber : scene.chambers)
    for (const Chamber::Pillar& pillar : chamber.pillars)
      add_shape(scene.shapes[pillar.shape], pillar_pose(state, pillar), ray, inside);
  return length_of(interval_set(std::move(inside)));
}

void expect_each_pixel_alone(const Scene& scene, const std::string& name) {
  const Timeline timeline(scene, scene.seed, 1);
  const FrameState state = at(timeline, 1);
  const Image seen = intervals_of(scene);
  const double side = state.window.size().x() / scene.film.width;
  for (int y = 0; y < seen.height; ++y)
    for (int x = 0; x < seen.width; ++x) {
      const Vec2 centre(state.window.low.x() + (x + 0.5) * side,
                        state.window.high.y() - (y + 0.5) * side);
      const double length = length_ahead(scene, state, {centre, {side, 0}});
      ASSERT_EQ(seen.at(x, y)[0], grey_of(length, scene.film.width))
          << name << " " << x << "," << y;
    }
}

TEST(ViewOfIntervals, IsWhatEachPixelFindsForItself) {
  for (const char* scene :
       {"tutorial/02_shapes", "tutorial/10_everything", "tutorial/11_journey", "chamber/mushroom",
        "chamber/lorentz", "chamber/stadium", "drawing/fading", "language/groups", "extreme/far",
        "extreme/huge", "extreme/tiny", "extreme/slivers", "extreme/near_parallel"}) {
    const std::string path = std::string("scenes/") + scene + ".toml";
    expect_each_pixel_alone(scene_at(path, {{"film.size", "[24, 14]"}}), scene);
  }
}

// Half the film lies inside: the grey is 127.5 but for rounding, which differs from pixel to pixel.
TEST(ViewOfIntervals, IsThatWhereRoundingDecidesTheGrey) {
  for (const char* x : {"0.3", "0.4", "0.7", "0.45"}) {
    std::string text = "flatray = 1\nfilm = { size = [40, 3], world = [[0, 0], [1.4, 0.105]] }\n";
    for (const double from : {0.0, 0.07, 0.21, 0.35})
      text += fmt::format(
          "[[entity]]\nat = [{}, 0]\nshape = {{ box = {{ min = [{}, -1], max = [{}, 1] }} }}\n", x,
          from, from + 0.35);
    expect_each_pixel_alone(scene_of(text), x);
  }
}

TEST(ViewOfIntervals, AsksOneRayARowOfTheWallsRoundParts) {
  const Scene scene = scene_of(R"(flatray = 1
film = { size = [40, 20], world = [[0, 0], [40, 20]] }
[[entity]]
shape = { box = { min = [4, 2], max = [6, 9] } }
[[entity]]
shape = { circle = { centre = [20, 10], radius = 5 } }
[[entity]]
shape = { segment = { from = [1, 1], to = [30, 15] } }
)");
  const Image wanted = intervals_of(scene);
  EXPECT_EQ(intervals_of(scene, counting_tracer()), wanted);
  EXPECT_EQ(tracer_counts().builds, 1U);
  EXPECT_EQ(tracer_counts().walls, 5U);
  EXPECT_EQ(tracer_counts().all, 20U);
  EXPECT_EQ(tracer_counts().nearest, 0U);
}

TEST(Views, BuildTheWallsOnceAndAskARayAPixel) {
  const Scene scene = scene_at("scenes/tutorial/11_journey.toml", {{"film.size", "[32, 18]"}});
  const Timeline timeline(scene, scene.seed, 1);
  const std::size_t walls =
      build_world(scene, at(timeline, 1), WorldOf::everything).surfaces.size();
  for (const View* view : views()) {
    if (view->asks_for_all) continue;
    const Image wanted = view_of(scene, view->name, {0.5, 0.25}, nullptr);
    EXPECT_EQ(view_of(scene, view->name, {0.5, 0.25}, counting_tracer()), wanted) << view->name;
    EXPECT_EQ(tracer_counts().builds, 1U) << view->name;
    EXPECT_EQ(tracer_counts().walls, walls) << view->name;
    EXPECT_EQ(tracer_counts().nearest, 32U * 18U) << view->name;
    EXPECT_EQ(tracer_counts().all, 0U) << view->name;
  }
}

// Parts of all bits that overlap, touch and repeat, and rays from among them.
TEST(RowLengths, AreOffByLessThanTheyTell) {
  const auto number = [](std::uint64_t& state) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(state >> 11) * 0x1p-53;
  };
  double worst = 0;
  for (std::uint64_t item = 0; item < 500; ++item) {
    std::uint64_t state = item + 1;
    const double side = 0.01 + number(state), low = number(state) - 0.5;
    std::vector<Range> world, first;
    for (int i = 0; i < 12; ++i) {
      const double at = low + side + 30 * side * number(state);
      world.push_back({at, at + 3 * side * number(state)});
    }
    for (const Range& part : world)
      first.push_back({(part.low - low) / side, (part.high - low) / side});
    RowLengths lengths(std::move(first));
    for (int i = 0; i < 32; ++i) {
      const double x = low + i * side;
      std::vector<Range> own;
      for (const Range& part : world)
        if (part.high >= x)
          own.push_back({std::max(part.low - x, 0.0) / side, (part.high - x) / side});
      const double difference =
          length_of(interval_set(std::move(own))) - lengths.ahead((x - low) / side);
      worst = std::max(worst, std::fabs(difference) / lengths.error());
    }
  }
  fmt::print("worst difference over error: {:.4f} of lengths along a row\n", worst);
  EXPECT_LT(worst, 1);
  EXPECT_GT(worst, 0);
}

}  // namespace
}  // namespace flatray
