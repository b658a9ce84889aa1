// needs: shapes/segment shapes/polygon shapes/convex
#include <gtest/gtest.h>

#include "app/answers/hit_report.h"
#include "study/texts.h"
#include "support/pictures.h"

namespace flatray {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t i = text.find(part); i != std::string::npos; i = text.find(part, i + 1)) ++found;
  return found;
}

// The paper's quadrilateral has four edges; its ray lies inside from 19/72 to 19/27.
TEST(HitSvg, ShowsTheShapeTheRayAndThePartInside) {
  const Scene scene = scene_at("scenes/paper/case_one.toml");
  const Timeline timeline(scene, scene.seed, 1);
  const FrameState state = at(timeline, 1);
  const NamedRay ray{"a < b & c", {{1, 2}, {22, 10}}};
  std::uint32_t quad = 0;
  while (scene.entities[quad].name != "polygon") ++quad;
  const std::vector<HitReport> reports = hit_reports(scene, state, ray, quad, kRay);
  const std::uint32_t entities[] = {quad};
  const std::string svg = svg_of(scene, state, entities, reports);
  EXPECT_TRUE(flatray::testing::is_well_formed(svg)) << svg;
  // Of a line and of its entry in the legend.
  EXPECT_EQ(count(svg, "class=\"s-axis\" stroke-width=\"1.5\"/>"), 4U);
  EXPECT_EQ(count(svg, "class=\"s-blue\""), 2U);
  EXPECT_EQ(count(svg, "class=\"s-vermillion\""), 2U);
  for (const char* words :
       {">x, world units</text>", ">y, world units</text>", ">ray</text>", ">inside</text>"})
    EXPECT_EQ(count(svg, words), 1U) << words;
  EXPECT_NE(svg.find("t = 0.263889<"), std::string::npos);
  EXPECT_NE(svg.find("a &lt; b &amp; c"), std::string::npos);
}

TEST(HitSvg, AMissHasNothingInside) {
  const Scene scene = scene_at("scenes/paper/case_one.toml");
  const Timeline timeline(scene, scene.seed, 1);
  const FrameState state = at(timeline, 1);
  std::uint32_t quad = 0;
  while (scene.entities[quad].name != "polygon") ++quad;
  const auto reports = hit_reports(scene, state, {"past", {{1, 20}, {0, 1}}}, quad, kRay);
  const std::uint32_t entities[] = {quad};
  EXPECT_EQ(count(svg_of(scene, state, entities, reports), "class=\"s-vermillion\""), 0U);
}

}  // namespace
}  // namespace flatray
