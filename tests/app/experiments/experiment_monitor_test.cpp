#include "app/experiments/experiment_monitor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "app/files/journal.h"
#include "base/number_text.h"
#include "geom/ray.h"

namespace flatray {
namespace {

// Found by a reviewer: --resume refused a block with an infinity that it had written.
TEST(BlocksOfExperiments, AreReadBackWhateverNumbersTheyHave) {
  const double least = std::numeric_limits<double>::denorm_min();
  std::string line = "7";
  for (const double number : {kInfinity, -kInfinity, std::nan(""), -0.0, least, 0.1})
    line += "," + number_text(number);
  EXPECT_TRUE(are_blocks("{}\n" + checked(line) + "\n"));
  for (const char* wrong : {"7,", "7,1e999", "7,1 ", "7,one", "x,1"})
    EXPECT_FALSE(are_blocks("{}\n" + checked(wrong) + "\n")) << wrong;
}

}  // namespace
}  // namespace flatray
