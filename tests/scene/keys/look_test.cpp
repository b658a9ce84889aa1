// needs: shapes/circle
#include <gtest/gtest.h>

#include "scene/scene_text.h"

namespace flatray {
namespace {

std::string with(const std::string& keys) { return with_shape("circle = { radius = 1 }") + keys; }

TEST(Looks, AStrokeSaysHowItJoinsEndsAndBreaks) {
  const Scene scene =
      loaded(with("stroke = { width = 2, joins = \"miter\", caps = \"butt\", miter_limit = 10, "
                  "dashes = [3, 1, 2], dash_offset = -1 }"))
          .scene;
  const Stroke& stroke = *scene.entities[0].stroke;
  EXPECT_EQ(stroke.joins, LineJoin::miter);
  EXPECT_EQ(stroke.caps, LineCap::butt);
  EXPECT_EQ(stroke.miter_limit, 10);
  EXPECT_EQ(stroke.dash_offset, -1);
  EXPECT_EQ(scene.dashes.at(stroke.dashes), (std::vector<double>{3, 1, 2, 3, 1, 2}));
}

TEST(Looks, AGradientHasItsStopsEvenlyOrWhereTheyAreWritten) {
  const Scene scene =
      loaded(with("fill = { linear = { from = [0, 0], to = [0, 2], stops = [\"#000000\", "
                  "\"#ff0000\", \"#ffffff00\"] } }\nstroke = { colour = { radial = { centre = [1, "
                  "1], radius = 3, stops = [[0.25, \"#000000\"], [0.25, \"#ffffff\"]] } } }"))
          .scene;
  const Gradient& fill = scene.gradients.at(scene.entities[0].fill->gradient);
  EXPECT_FALSE(fill.radial);
  ASSERT_EQ(fill.stops.size(), 3U);
  EXPECT_EQ(fill.stops[1].at, 0.5);
  EXPECT_EQ(fill.stops[2].colour.a, 0);
  const Gradient& stroke = scene.gradients.at(scene.entities[0].stroke->colour.gradient);
  EXPECT_TRUE(stroke.radial);
  EXPECT_EQ(stroke.along, Vec2(3, 0));
  EXPECT_EQ(stroke.stops[0].at, 0.25);
}

TEST(Looks, AFillThatHidesItsEntityIsWarnedOf) {
  const auto warning = [](const std::string& more) {
    const Diagnostics warnings = loaded(with("fill = \"none\"\n" + more)).warnings;
    return warnings.empty() ? std::string() : format(warnings, "warning");
  };
  const std::string told = warning("");
  EXPECT_TRUE(told.starts_with(
      "t.toml:5:8: warning: the entity draws nothing: it has no fill and no stroke\n"))
      << told;
  EXPECT_NE(told.find("write stroke = { colour = \"#333333\" }, or stroke = \"none\" to hide it"),
            std::string::npos)
      << told;
  for (const char* seen_or_meant :
       {"stroke = { width = 1 }", "stroke = \"none\"", "bounding_box = { width = 1 }",
        "material = \"mirror\"", "material = { diffuse = { reflectance = 0.5 } }"})
    EXPECT_EQ(warning(seen_or_meant), "") << seen_or_meant;
  EXPECT_TRUE(loaded(with("")).warnings.empty());
}

TEST(Looks, WhatCannotBeDrawnIsRefused) {
  const std::string line = "fill = { linear = { from = [0, 0], to = [1, 0], stops = ";
  const Refused cases[] = {
      {"stroke = { joins = \"mitre\" }", "did you mean 'miter'?"},
      {"stroke = { joins = \"sharp\" }", "known: round, miter, bevel"},
      {"stroke = { caps = \"flat\" }", "5:19: error: unknown stroke.caps 'flat'"},
      {"stroke = { miter_limit = 0.5 }", "stroke.miter_limit is below 1"},
      {"stroke = { dashes = [] }", "stroke.dashes have no length"},
      {"stroke = { dashes = [0, 0] }", "stroke.dashes have no length"},
      {"stroke = { dashes = [1, -1] }", "5:25: error: stroke.dashes[1] is not a length"},
      {"stroke = { dash_offset = 1e301 }", "stroke.dash_offset lies beyond 1e300"},
      {"opacity = 1.5", "5:11: error: entity.opacity does not lie between 0 and 1"},
      {"opacity = { keys = [[0, 0], [1, 1.5]] }",
       "5:11: error: entity.opacity does not lie between 0 and 1"},
      {"opacity = -1", "0 is not seen, 1 is opaque"},
      {line + "[\"#000000\"] } }", "linear.stops has 1 colour"},
      {line + "[[0.5, \"#000000\"], [0.2, \"#000000\"]] } }", "comes before the one it follows"},
      {line + "[[0, \"#000000\"], [2, \"#000000\"]] } }", "does not lie between 0 and 1"},
      {line + "[[0], \"#000000\"] } }", "linear.stops[0] is not a place and a colour"},
      {"fill = { linear = { from = [1, 1], to = [1, 1], stops = [\"#000000\", \"#000000\"] } }",
       "5:19: error: the gradient has no length"},
      {"fill = { radial = { radius = 0, stops = [\"#000000\", \"#000000\"] } }",
       "radial.radius is not above 0"},
      {"fill = { conic = {} }", "entity.fill is a table, not a string"},
  };
  expect_refused(cases, [](const std::string& keys) { return refusal(with(keys)); });
}

}  // namespace
}  // namespace flatray
