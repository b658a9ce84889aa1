#include "geom/reflect.h"

#include <gtest/gtest.h>

#include "base/philox.h"
#include "geom/exact.h"
#include "geom/refract.h"

namespace flatray {
namespace {

double draw(std::uint64_t item, std::uint32_t k) {
  return 2 * unit_double(random_bits(5, Stream::test, 0, item, k)) - 1;
}

TEST(Reflect, AxesOnlyFlipSigns) {
  EXPECT_EQ(reflect({0.1, -0.7}, {3, 0}), Vec2(0.1, 0.7));
  EXPECT_EQ(reflect({0.1, -0.7}, {0, -1e-310}), Vec2(-0.1, -0.7));
  EXPECT_FALSE(std::signbit(reflect({1, 0}, {1, 0}).y()));
}

TEST(Reflect, DiagonalsSwapComponents) {
  EXPECT_EQ(reflect({0.1, -0.7}, {-3, -3}), Vec2(-0.7, 0.1));
  EXPECT_EQ(reflect({0.1, -0.7}, {2, -2}), Vec2(0.7, -0.1));
}

TEST(Reflect, IntegersOfAPythagoreanMirrorAreExact) {
  EXPECT_EQ(reflect({5, 0}, {2, 1}), Vec2(3, 4));
  EXPECT_EQ(reflect({13, 0}, {3, 2}), Vec2(5, 12));
}

// d' - d is across the mirror and d' + d along it, with rationals; half an ulp a component.
TEST(Reflect, EveryComponentIsTheNearestDouble) {
  for (std::uint64_t i = 0; i < 500; ++i) {
    const double scale = std::ldexp(1.0, static_cast<int>(i % 11) * 180 - 900);
    const Vec2 d(draw(i, 0) * scale, draw(i, 1) * scale), e(draw(i, 2) / scale, draw(i, 3) / scale);
    const Vec2 mirrored = reflect(d, e);
    const Rational ex = e.x(), ey = e.y(), dot = ex * d.x() + ey * d.y();
    const Rational factor = dot * 2 / (ex * ex + ey * ey);
    EXPECT_EQ(mirrored.x(), (factor * ex - d.x()).nearest());
    EXPECT_EQ(mirrored.y(), (factor * ey - d.y()).nearest());
  }
}

TEST(Reflect, TwiceIsTheSameWithinRounding) {
  for (std::uint64_t i = 0; i < 500; ++i) {
    const Vec2 d(draw(i, 4), draw(i, 5)), e(draw(i, 6), draw(i, 7));
    EXPECT_LE((reflect(reflect(d, e), e) - d).norm(), 4 * 0x1p-53 * d.norm());
  }
}

// Found by a reviewer: between equal indices nothing is reflected, however it grazes.
TEST(Refraction, OfMediaAlikeGoesStraightOn) {
  for (const double cosine : {1.0, 0.5, 5e-9, 1e-150}) {
    const auto same = refraction(1, cosine);
    ASSERT_TRUE(same);
    EXPECT_EQ(same->beyond, cosine);
    EXPECT_EQ(same->reflected, 0);
  }
  const auto denser =
      refraction(1 - 0x1p-52, 5e-9);  // 2 (1 - ratio) and cosine^2, to some parts in 10^16
  ASSERT_TRUE(denser);
  EXPECT_DOUBLE_EQ(denser->beyond, std::sqrt(0x1p-51 + 2.5e-17));
}

}  // namespace
}  // namespace flatray
