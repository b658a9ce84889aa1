// needs: shapes/circle
#include "app/experiments/experiment_sweep.h"

#include <gtest/gtest.h>

namespace flatray {
namespace {

// What stands below the plot of a sweep over that key.
std::string label_of(const std::string& key) {
  SweepResults sweep("mean-free-path", {key, {"1", "2"}});
  for (const double value : {1.0, 2.0}) {
    ExperimentResult one;
    one.measures.push_back({"length", value});
    sweep.add(std::to_string(value), one);
  }
  for (const ExperimentResult::File& file : std::move(sweep).result().files) {
    const std::size_t at = file.content.find(">" + key);
    if (file.name == "sweep_length.svg" && at != std::string::npos)
      return file.content.substr(at + 1, file.content.find('<', at) - at - 1);
  }
  return "";
}

TEST(Sweeps, NameTheirKeyAndItsUnit) {
  EXPECT_EQ(label_of("entity.0.angle"), "entity.0.angle, degrees");
  EXPECT_EQ(label_of("entity.kite.angular_velocity"),
            "entity.kite.angular_velocity, degrees a second");
  EXPECT_EQ(label_of("fps"), "fps");
  EXPECT_EQ(label_of("chamber.0.pillars.0.shape.circle.radius"),
            "chamber.0.pillars.0.shape.circle.radius");
  EXPECT_EQ(label_of("seed"), "seed");
  EXPECT_EQ(label_of("entity.0.at.1"), "entity.0.at.1");
}

}  // namespace
}  // namespace flatray
