// needs: shapes/circle shapes/polygon shapes/convex
// The paper's Figure 3: moving the frame's origin instead of every object.
#include <gtest/gtest.h>

#include "support/pictures.h"

namespace flatray {
namespace {

const std::vector<Override> kMoveObjects = {{"camera.motion", "\"objects\""}};

TEST(FrameTrick, EqualsMovingEveryObjectBitForBitWherePositionsAreDyadic) {
  const Scene frame = scene_at("scenes/paper/frame_trick.toml");
  const Scene objects = scene_at("scenes/paper/frame_trick.toml", kMoveObjects);
  ASSERT_EQ(objects.camera.motion, CameraMotion::objects);
  const Image first = picture(frame, 1);
  for (unsigned k = 1; k <= frame.frames; ++k) {
    const Image image = picture(frame, k);
    EXPECT_EQ(image, picture(objects, k)) << "frame " << k;
    if (k > 1) {
      EXPECT_NE(image, first) << "the camera did not move in frame " << k;
    }
  }
}

// Elsewhere each way rounds on its own; the sums differ by an ulp of a coordinate.
TEST(FrameTrick, DiffersByAtMostOneLevelInATenthOfAPercentOfPixelsElsewhere) {
  std::uint64_t different = 0, all = 0;
  for (unsigned k = 1; k <= 40; ++k) {
    const std::string velocity = fmt::format("[{}, {}]", 0.37 + 0.1 * k, 0.11 * k);
    const std::vector<Override> shared = {{"camera.velocity", velocity},
                                          {"entity.ball.velocity", "[1.7, 0.3]"},
                                          {"film.world", "[[0.1, 0.3], [31.7, 17.9]]"}};
    std::vector<Override> objects = shared;
    objects.insert(objects.end(), kMoveObjects.begin(), kMoveObjects.end());
    const Image a = picture(scene_at("scenes/paper/frame_trick.toml", shared), 1 + k % 8);
    const Image b = picture(scene_at("scenes/paper/frame_trick.toml", objects), 1 + k % 8);
    ASSERT_EQ(a.pixels.size(), b.pixels.size());
    for (std::size_t i = 0; i < a.pixels.size(); i += 3) {
      int worst = 0;
      for (std::size_t c = i; c < i + 3; ++c)
        worst = std::max(worst, std::abs(a.pixels[c] - b.pixels[c]));
      ASSERT_LE(worst, 1);
      different += worst != 0 ? 1 : 0;
      ++all;
    }
  }
  std::printf("frame trick: %llu of %llu pixels differ by one level\n",
              static_cast<unsigned long long>(different), static_cast<unsigned long long>(all));
  EXPECT_LE(different * 1000, all);
}

}  // namespace
}  // namespace flatray
