// needs: gl backends/gl
// Regions of whole pixels, of which every sample sees the same: GL has the very light of the software back end.
#include <gtest/gtest.h>

#include "base/philox.h"
#include "render/backend.h"
#include "render/gradient.h"

namespace flatray {
namespace {

constexpr int kWidth = 61, kHeight = 47;

std::unique_ptr<Renderer> opened(const std::string& name, unsigned samples) {
  for (const Backend* one : backends())
    if (name == one->name)
      if (auto renderer = one->open({2, samples})) return std::move(*renderer);
  return nullptr;
}

class Draws {
 public:
  explicit Draws(std::uint64_t seed) : seed_(seed) {}
  int below(int count) { return static_cast<int>(unit() * count); }
  double unit() { return unit_double(random_bits(seed_, Stream::test, 1, 0, next_++)); }
  float light() { return static_cast<float>(unit()); }
  LinearColour colour() { return {light(), light(), light(), below(2) == 0 ? 1.0F : light()}; }

 private:
  std::uint64_t seed_;
  std::uint32_t next_ = 0;
};

void add_box(const Vec2& a, const Vec2& c, bool reversed, std::vector<Segment>& edges) {
  const Vec2 b(c.x(), a.y()), d(a.x(), c.y());
  if (reversed)
    edges.insert(edges.end(), {{a, d}, {d, c}, {c, b}, {b, a}});
  else
    edges.insert(edges.end(), {{a, b}, {b, c}, {c, d}, {d, a}});
}

// Boxes over each other, either way round, in one region of either rule; now and then so often round
// that a count of 8 bits begins again.
FillPath boxes(Draws& draw, bool many) {
  FillPath path;
  path.rule = draw.below(2) == 0 ? FillRule::nonzero : FillRule::even_odd;
  for (int box = 0; box < 3; ++box) {
    const Vec2 at(draw.below(kWidth) - 8, draw.below(kHeight) - 8);
    const Vec2 to = at + Vec2(1 + draw.below(40), 1 + draw.below(40));
    const bool reversed = draw.below(2) == 0;
    for (int times = many && box == 0 ? 256 : 1; times > 0; --times)
      add_box(at, to, reversed, path.edges);
  }
  return path;
}

FilmGradient gradient(Draws& draw) {
  FilmGradient made;
  made.radial = draw.below(2) == 0;
  made.origin = {draw.below(kWidth) + 0.5, draw.below(kHeight) + 0.5};
  made.axis = {1.0 / 32, draw.below(2) / 16.0};
  made.per_pixel = 1.0 / 32;
  for (int stop = 0; stop < 3; ++stop) made.stops.push_back({0.5 * stop, draw.colour()});
  return made;
}

DrawList list_of(std::uint64_t seed) {
  Draws draw(seed);
  DrawList list{kWidth, kHeight, draw.colour(), Coverage::area, {}};
  if (seed % 3 == 0) list.coverage = Coverage::centre;
  for (std::uint32_t item = 0; item < 12; ++item) {
    list.items.push_back({boxes(draw, item == seed % 24), draw.colour()});
    DrawItem& made = list.items.back();
    if (draw.below(3) == 0) made.gradient = gradient(draw), made.colour = summary(*made.gradient);
    if (item % 4 >= 2 && seed % 2 == 0) made.layer = 1 + item / 4, made.opacity = 0.625F;
  }
  return list;
}

TEST(GlPictures, OfWholePixelsHaveTheLightOfTheSoftwareBackEnd) {
  for (const unsigned samples : {4U, 16U}) {
    const auto renderer = opened("gl", samples);
    ASSERT_TRUE(renderer);
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      const DrawList list = list_of(seed);
      LinearImage drawn;
      ASSERT_TRUE(renderer->draw(list, {}, drawn));
      ASSERT_EQ(drawn.pixels, render_linear(list, {}).pixels) << seed << ", " << samples;
    }
  }
}

// Films of many tiles, one that is a part of a larger one, and one that follows a smaller one.
TEST(GlPictures, OfAnySizeOneAfterAnotherAreTheSame) {
  const auto renderer = opened("gl", 4);
  ASSERT_TRUE(renderer);
  for (const auto& [width, height] : {std::pair(9, 5), std::pair(1500, 6), std::pair(3, 1300)}) {
    DrawList list = list_of(2);
    list.width = width, list.height = height;
    LinearImage drawn, part;
    ASSERT_TRUE(renderer->draw(list, {}, drawn));
    EXPECT_EQ(drawn.pixels, render_linear(list, {}).pixels) << width;
    const FrameOptions crop{PixelBox{width / 3, height / 3, width / 2, height / 2}, 1, false};
    ASSERT_TRUE(renderer->draw(list, crop, part));
    EXPECT_EQ(part.pixels, render_linear(list, crop).pixels) << width;
  }
}

// Of a disc a share of samples near its area, the same from all sides.
TEST(GlPictures, OfDiscsHaveTheirArea) {
  for (const unsigned samples : {4U, 16U}) {
    const auto renderer = opened("gl", samples);
    ASSERT_TRUE(renderer);
    for (const double hole : {-1.0, 9.5}) {
      const DrawList list{kWidth,
                          kHeight,
                          {0, 0, 0, 1},
                          Coverage::area,
                          {{FillRing{{30.25, 23.5}, 18.75, hole}, {1, 1, 1, 1}}}};
      LinearImage drawn;
      ASSERT_TRUE(renderer->draw(list, {}, drawn));
      double sum = 0;
      for (std::size_t i = 0; i < drawn.pixels.size(); i += 3)
        sum += static_cast<double>(drawn.pixels[i]);
      const double area = 3.14159265 * (18.75 * 18.75 - (hole > 0 ? hole * hole : 0));
      EXPECT_NEAR(sum, area, 4) << hole;
    }
  }
}

TEST(GlPictures, SayByWhomTheyAreDrawn) {
  for (const auto& [name, maker] : {std::pair("osmesa", "OSMesa"), std::pair("egl", "EGL")})
    if (const auto renderer = opened(name, 4)) {
      EXPECT_NE(renderer->description().find(maker), std::string::npos) << renderer->description();
      EXPECT_NE(renderer->description().find("Mesa "), std::string::npos);
    }
}

}  // namespace
}  // namespace flatray
