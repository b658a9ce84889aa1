#include "study/stability/scale_sweep.h"

#include <gtest/gtest.h>

#include "study/plots/plot.h"
#include "study/texts.h"

namespace flatray {
namespace {

std::vector<const Tracer*> exact_tracers() {
  std::vector<const Tracer*> exact;
  for (const Tracer* tracer : tracers())
    if (tracer->exact) exact.push_back(tracer);
  return exact;
}

TEST(ScaleSweep, GoesFromTheSmallestToTheLargestScales) {
  EXPECT_EQ(sweep_steps().front(), -1000);
  EXPECT_EQ(sweep_steps().back(), 1000);
}

TEST(ScaleSweep, FindsExactTracersRightAtEveryScaleAndOffset) {
  const std::vector<const Tracer*> exact = exact_tracers();
  for (const double scale : {-1000.0, -500.0, 0.0, 1000.0})
    for (const double offset : {-1000.0, 0.0, 50.0, 1000.0}) {
      const SweepCell cell = sweep_cell(exact, 3, scale, offset);
      EXPECT_EQ(cell.rays, 48U);
      for (std::size_t k = 0; k < exact.size(); ++k)
        EXPECT_EQ(cell.wrong[k] + cell.off[k], 0U)
            << exact[k]->name << " 2^" << scale << " + 2^" << offset;
    }
}

TEST(ScaleSweep, FindsFloatsWrongWhereTheyHaveNoBitsLeft) {
  const Tracer* const single[] = {find_tracer("float")};
  EXPECT_GT(sweep_cell(single, 3, 0, 40).wrong[0], 0U);
  EXPECT_GT(sweep_cell(single, 3, -1000, -1000).wrong[0], 0U);
}

TEST(HeatMap, HasTheColoursOfItsBar) {
  const HeatMap map{"<t>", "x", "y", {0, 1}, {0, 1, 2}, {0, 0.5, 0, 0, 1, 0}};
  const Plot plot = plot_of(map);
  const std::string text = svg(plot);
  EXPECT_TRUE(testing::is_well_formed(text));
  EXPECT_TRUE(testing::has(text, "&lt;t&gt;"));
  const Image& cells = plot.map->image;
  const auto colour = [&](int x, int y) {
    return std::vector<int>(cells.at(x, y), cells.at(x, y) + 3);
  };
  const Image& bar = plot.bar->strip;
  const auto step = [&](int y) { return std::vector<int>(bar.at(0, y), bar.at(0, y) + 3); };
  EXPECT_EQ(colour(0, 0), step(0));  // a share of 1, y upwards
  EXPECT_EQ(colour(0, 2), step(bar.height - 1));
  EXPECT_LT(colour(1, 2)[1], colour(0, 2)[1] / 2);
  EXPECT_LT(colour(0, 0)[0], 130);  // dark
  // The bar has no line of its own at 0.
  for (std::size_t part = 0; part < 3; ++part)
    EXPECT_LT(std::abs(step(bar.height - 2)[part] - step(bar.height - 1)[part]), 3);
}

}  // namespace
}  // namespace flatray
