// needs: shapes/circle shapes/box shapes/arc shapes/polyline shapes/ellipse
#include <fmt/core.h>
#include <gtest/gtest.h>

#include "render/frame.h"
#include "render/plan.h"
#include "render/view.h"
#include "support/pictures.h"

namespace flatray {
namespace {

// A group of all kinds of things, with every length times `s`, in a group that makes up for it: all
// are powers of two, so that nothing is rounded otherwise.
std::string things(double s, double scale) {
  const auto n = [s](double v) { return fmt::format("{}", s * v); };
  const auto p = [&](double x, double y) { return "[" + n(x) + ", " + n(y) + "]"; };
  const auto entity = [](const std::string& shape, const std::string& keys) {
    return "[[entity]]\ngroup = \"g\"\nshape = " + shape + "\n" + keys + "\n";
  };
  return fmt::format(
             "flatray = 1\nframes = 3\nfps = 1\n"
             "film = {{ size = [160, 120], world = [[0, 0], [40, 30]] }}\n"
             "[[group]]\nname = \"g\"\nat = [20, 15]\nangle = 30\nscale = {}\n",
             scale) +
         entity("{ box = { min = " + p(-8, -6) + ", max = " + p(8, 6) + " } }",
                "stroke = { width = " + n(0.5) + ", dashes = [" + n(2) + ", " + n(1) +
                    "], dash_offset = " + n(0.25) + " }\nvelocity = " + p(1, 0.5) +
                    "\nfill = { linear = { from = " + p(-8, 0) + ", to = " + p(8, 0) +
                    ", stops = [\"#ff0000\", \"#0000ff\"] } }") +
         entity("{ circle = { radius = " + n(3) + " } }",
                "at = " + p(4, -4) +
                    "\nstroke = { width_px = 3 }\nfill = \"#00800080\"\n"
                    "bounding_box = { width = " +
                    n(0.25) + " }") +
         entity("{ arc = { radius = " + n(5) + ", from = 20, to = 250 } }",
                "stroke = { width = " + n(0.75) + " }") +
         entity("{ ellipse = { radii = " + p(6, 2) + " } }", "at = " + p(-5, 5)) +
         entity(
             "{ polyline = { points = [" + p(-9, -9) + ", " + p(0, 3) + ", " + p(9, -9) + "] } }",
             "stroke = { width = " + n(0.5) + ", joins = \"miter\" }");
}

TEST(GroupScale, DrawsWhatLongerLengthsWouldTwiceOverInGroupsOfGroups) {
  const Scene plain = scene_of(things(1, 1));
  for (const double scale : {4.0, 0.125}) {
    const Scene scaled = scene_of(things(1 / scale, scale));
    for (unsigned frame = 1; frame <= 3; ++frame) {
      const Image expected = picture(plain, frame);
      EXPECT_TRUE(has_content(expected));
      EXPECT_EQ(picture(scaled, frame), expected) << scale << ", frame " << frame;
    }
  }
}

TEST(GroupScale, RaysMeetWhatIsDrawn) {
  const Scene plain = scene_of(things(1, 1)), scaled = scene_of(things(0.25, 4));
  for (const View* view : views()) {
    const auto seen = [&](const Scene& scene) {
      const Timeline timeline(scene, scene.seed, 1);
      return draw_view({view, {3, 4}}, nullptr, scene, at(timeline, 1), {});
    };
    EXPECT_EQ(seen(plain), seen(scaled)) << view->name;
  }
}

}  // namespace
}  // namespace flatray
