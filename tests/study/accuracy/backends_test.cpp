// needs: gl
// The GL back ends against exact samples: what they draw, on real Mesa.
#include <gtest/gtest.h>

#include <cstdlib>
#include <numbers>

#include "base/parallel.h"
#include "base/philox.h"
#include "base/portable_math.h"
#include "render/backend.h"
#include "render/gradient.h"
#include "study/accuracy/point_samples.h"

namespace flatray {
namespace {

constexpr int kWidth = 97, kHeight = 71;

class GlBackends : public ::testing::Test {
 protected:
  static std::unique_ptr<Renderer> opened(const std::string& name, unsigned samples) {
    for (const Backend* one : backends())
      if (name == one->name) {
        auto renderer = one->open({2, samples});
        EXPECT_TRUE(renderer) << format(renderer.error());
        return renderer ? std::move(*renderer) : nullptr;
      }
    return nullptr;
  }
};

// Numbers of one random list.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : seed_(seed) {}
  double operator()(double low, double high) {
    return low + (high - low) * 0x1p-64 *
                     static_cast<double>(random_bits(seed_, Stream::test, 0, 0, next_++));
  }

 private:
  std::uint64_t seed_;
  std::uint32_t next_ = 0;
};

// `corners` on a circle, every `step`-th after another: convex for step 1, a star for more.
void add_star(Draws& draw, int corners, int step, double reach, std::vector<Segment>& edges) {
  const Vec2 centre(draw(0, kWidth), draw(0, kHeight));
  const double radius = draw(1, reach), turn = draw(0, 6);
  const auto corner = [&](int i) {
    const double angle = turn + 2 * std::numbers::pi * (i % corners) / corners;
    return Vec2(centre + radius * Vec2(portable::cos(angle), portable::sin(angle)));
  };
  for (int i = 0; i < corners; ++i) edges.push_back({corner(i * step), corner((i + 1) * step)});
}

LinearColour random_colour(Draws& draw) {
  const auto light = [&] { return static_cast<float>(draw(0, 1)); };
  return {light(), light(), light(), draw(0, 2) < 1 ? 1.0F : light()};
}

// Every other one has its stops at the very centres of pixels.
FilmGradient random_gradient(Draws& draw) {
  const auto any = [&](int count) { return static_cast<int>(draw(0, count)); };
  FilmGradient gradient;
  gradient.radial = any(2) == 0;
  gradient.origin = {draw(-40, 140), draw(-40, 140)};
  Vec2 along(draw(-90, 90), draw(-90, 90));
  if (any(2) == 0) {
    gradient.origin = {any(kWidth) + 0.5, any(kHeight) + 0.5};
    along = {any(2) == 0 ? 16 : 0, 16};
  }
  gradient.axis = along / along.squaredNorm();
  gradient.per_pixel = 1 / std::sqrt(along.squaredNorm());
  for (int at = 0; at <= 4 && gradient.stops.size() < 8; at += any(4))
    gradient.stops.push_back({0.25 * at, random_colour(draw)});
  return gradient;
}

void give_gradient(FilmGradient gradient, DrawItem& item) {
  item.colour = summary(gradient);
  item.gradient = std::move(gradient);
}

DrawItem random_item(Draws& draw) {
  const auto any = [&](int count) { return static_cast<int>(draw(0, count)); };
  const LinearColour colour = random_colour(draw);
  const double reach = any(8) == 0 ? 1e9 : any(4) == 0 ? 3000 : 40;
  if (any(4) == 0) {
    const double radius = draw(0.5, reach);
    return {
        FillRing{
            {draw(0, kWidth), draw(0, kHeight)}, radius, any(2) == 0 ? -1 : draw(0, 1) * radius},
        colour};
  }
  FillPath path;
  path.rule = any(2) == 0 ? FillRule::nonzero : FillRule::even_odd;
  const int stars = 1 + any(4), step = any(2) == 0 ? 1 : 2 + any(2);
  for (int i = 0; i < stars; ++i) add_star(draw, 5 + 2 * any(4), step, reach, path.edges);
  if (any(3) == 0) std::reverse(path.edges.begin(), path.edges.end());  // rings out of order
  return {std::move(path), colour};
}

// Neighbours are faded as one, now and then.
void add_layers(Draws& draw, std::vector<DrawItem>& items) {
  std::uint32_t layer = 0;
  for (std::size_t i = 0; i < items.size();) {
    const std::size_t end = std::min(i + 1 + static_cast<std::size_t>(draw(0, 4)), items.size());
    const bool layered = draw(0, 2) < 1;
    const auto opacity = static_cast<float>(draw(0, 1));
    if (layered) ++layer;
    for (; i < end; ++i)
      if (layered) items[i].layer = layer, items[i].opacity = opacity;
  }
}

DrawList random_list(std::uint64_t seed) {
  Draws draw(seed);
  DrawList list{kWidth, kHeight, {0.2F, 0.4F, 0.1F, 1}, Coverage::area, {}};
  if (seed % 3 == 0) list.background.a = 0.3F;
  if (seed % 5 == 0) list.coverage = Coverage::centre;
  const int items = static_cast<int>(draw(1, 30));
  for (int i = 0; i < items; ++i) {
    list.items.push_back(random_item(draw));
    if (draw(0, 4) < 1) give_gradient(random_gradient(draw), list.items.back());
  }
  if (seed % 4 < 2) add_layers(draw, list.items);
  return list;
}

// Items of whole pixels, of which every sample sees the same.
DrawList random_boxes(std::uint64_t seed) {
  Draws draw(seed);
  const auto any = [&](int count) { return static_cast<int>(draw(0, count)); };
  DrawList list{kWidth, kHeight, {0.2F, 0.4F, 0.1F, 1}, Coverage::area, {}};
  for (int i = 0; i < 20; ++i) {
    const Vec2 a(any(kWidth), any(kHeight)), c = a + Vec2(1 + any(60), 1 + any(60));
    const Vec2 b(c.x(), a.y()), d(a.x(), c.y());
    list.items.push_back(
        {FillPath{{{a, b}, {b, c}, {c, d}, {d, a}}, FillRule::nonzero, true}, random_colour(draw)});
    if (any(2) == 0) give_gradient(random_gradient(draw), list.items.back());
  }
  if (seed % 2 == 0) add_layers(draw, list.items);
  return list;
}

TEST_F(GlBackends, DrawWhatExactSamplesSee) {
  for (const unsigned samples : {4U, 16U}) {
    const auto renderer = opened("gl", samples);
    ASSERT_TRUE(renderer);
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      const DrawList list = random_list(seed);
      Image drawn;
      const auto done = renderer->draw(list, {}, drawn);
      ASSERT_TRUE(done) << format(done.error());
      const DifferenceCauses why = difference_causes(
          drawn, render_image(list, {}),
          point_sampled(list, sample_places(list.coverage, samples), 1), edge_pixels(list));
      EXPECT_EQ(why.unexplained, 0U) << "seed " << seed << ", samples " << samples;
      EXPECT_LE(why.flat_worst, 1) << "seed " << seed << ", samples " << samples;
      EXPECT_LE(50 * why.rounded, why.edge + 100) << "seed " << seed << ", samples " << samples;
    }
  }
}

TEST_F(GlBackends, WholePixelsHaveTheVeryLightOfTheSoftwareBackEnd) {
  for (const unsigned samples : {4U, 16U}) {
    const auto renderer = opened("gl", samples);
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
      const DrawList list = random_boxes(seed);
      LinearImage drawn;
      ASSERT_TRUE(renderer->draw(list, {}, drawn));
      EXPECT_EQ(drawn.pixels, render_linear(list, {}).pixels) << seed;
    }
  }
}

TEST_F(GlBackends, CentresOnOutlinesGoRightAndDown) {
  DrawList list{9, 7, {1, 1, 1, 1}, Coverage::centre, {}};
  const Vec2 a(1.5, 1.5), b(6.5, 1.5), c(6.5, 4.5), d(1.5, 4.5), tip(4.5, 6.5);
  list.items.push_back(
      {FillPath{{{a, b}, {b, c}, {c, d}, {d, a}}, FillRule::nonzero, true}, {0, 0, 0, 1}});
  list.items.push_back(
      {FillPath{{{d, c}, {c, tip}, {tip, d}}, FillRule::nonzero, true}, {1, 0, 0, 0.5F}});
  Image drawn;
  ASSERT_TRUE(opened("gl", 4)->draw(list, {}, drawn));
  EXPECT_EQ(drawn, render_image(list, {}));
}

TEST_F(GlBackends, TilesAndCropsShowTheSame) {
  DrawList list = random_list(13);
  list.width = 2100;
  const auto renderer = opened("gl", 4);
  Image whole, part;
  ASSERT_TRUE(renderer->draw(list, {}, whole));
  ASSERT_TRUE(renderer->draw(list, {PixelBox{1990, 3, 100, 40}, 1, false}, part));
  for (int y = 0; y < part.height; ++y)
    EXPECT_TRUE(std::equal(part.at(0, y), part.at(0, y) + 3 * part.width, whole.at(1990, y + 3)));
}

TEST_F(GlBackends, ThreadsDrawSideBySide) {
  const auto renderer = opened("gl", 4);
  std::vector<Image> pictures(24);
  parallel_for(pictures.size(), 4, [&](std::size_t i) {
    ASSERT_TRUE(renderer->draw(random_list(i % 6), {}, pictures[i]));
  });
  for (std::size_t i = 6; i < pictures.size(); ++i) EXPECT_EQ(pictures[i], pictures[i % 6]) << i;
}

TEST_F(GlBackends, ALinearPictureHasTheLightOfTheOther) {
  const auto renderer = opened("gl", 4);
  const DrawList list{3, 2, {0.25F, 0.5F, 4, 1}, Coverage::area, {}};
  LinearImage light;
  ASSERT_TRUE(renderer->draw(list, {}, light));
  for (std::size_t i = 0; i < light.pixels.size(); ++i)
    EXPECT_EQ(light.pixels[i], (std::array{0.25F, 0.5F, 4.0F}[i % 3]));  // nothing is clamped
}

// A triangle round which 256 windings leave nothing to a stencil, and stars that wind either way.
TEST_F(GlBackends, ARegionMayWindAsOftenAsItLikes) {
  DrawList list{30, 24, {1, 1, 1, 1}, Coverage::area, {}};
  for (const std::uint64_t seed : {1U, 2U}) {
    Draws draw(seed);
    const Vec2 a(2, 2.3), b(27.7, 8), c(9, 21.1);
    FillPath path;
    for (int i = 0; i < 256; ++i) path.edges.insert(path.edges.end(), {{a, b}, {b, c}, {c, a}});
    for (int i = 0; i < 8; ++i) {
      add_star(draw, 5, 2, 60, path.edges);
      if (i % 2 == 0) continue;
      for (std::size_t k = path.edges.size() - 5; k < path.edges.size(); ++k)
        std::swap(path.edges[k].a, path.edges[k].b);
    }
    list.items.push_back({path, {0, 0, 1, 0.5F}});
    if (seed == 1) continue;
    give_gradient(random_gradient(draw), list.items.back());
    list.items.back().layer = 1, list.items.back().opacity = 0.75F;
  }
  for (const Coverage coverage : {Coverage::area, Coverage::centre}) {
    list.coverage = coverage;
    Image drawn;
    ASSERT_TRUE(opened("gl", 4)->draw(list, {}, drawn));
    const DifferenceCauses why =
        difference_causes(drawn, render_image(list, {}),
                          point_sampled(list, sample_places(coverage, 4), 1), edge_pixels(list));
    EXPECT_EQ(why.unexplained, 0U);
    EXPECT_EQ(why.flat_worst, 0);
    EXPECT_LE(10 * why.rounded, why.edge);
  }
}

}  // namespace
}  // namespace flatray
