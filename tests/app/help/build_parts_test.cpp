#include "app/help/build_parts.h"

#include "scene/scene_text.h"

namespace flatray {
namespace {

constexpr std::string_view kNames[] = {"MPFR", "GL", "shapes/circle", "passes/chambers",
                                       "metrics/psnr"};

TEST(MissingParts, OfARoomWithARayConcernItWhereItCouldUseThem) {
  const Scene scene = loaded(R"(
flatray = 1
[[chamber]]
shape = { box = { min = [0, 0], max = [1, 1] } }
[[ray]]
at = [0.5, 0.5]
direction = [1, 0.5]
)")
                          .scene;
  const std::vector<MissingPart> parts = missing_parts(scene, kNames);
  ASSERT_EQ(parts.size(), 5U);
  EXPECT_TRUE(parts[0].concerns);
  EXPECT_EQ(parts[0].reason, "1 ray whose orbit it would certify");
  EXPECT_FALSE(parts[1].concerns);
  EXPECT_FALSE(parts[2].concerns);
  EXPECT_EQ(parts[2].reason, "a scene that needs it is refused");
  EXPECT_TRUE(parts[3].concerns);
  EXPECT_FALSE(parts[4].concerns);
}

TEST(MissingParts, OfASceneOfOneBoxConcernNothing) {
  const Scene scene = loaded(with_shape("box = { min = [0, 0], max = [1, 1] }")).scene;
  for (const MissingPart& part : missing_parts(scene, kNames))
    EXPECT_FALSE(part.concerns) << part.name;
  EXPECT_TRUE(missing_parts(scene, {}).empty());
}

}  // namespace
}  // namespace flatray
