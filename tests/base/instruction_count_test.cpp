#include "base/instruction_count.h"

#include <gtest/gtest.h>

namespace flatray {
namespace {

// So many turns of a loop that nothing leaves out.
void turns(unsigned count) {
  volatile unsigned sum = 0;
  for (unsigned i = 0; i < count; ++i) sum = sum + i;
}

TEST(InstructionCount, TellsTheWorkOrThatItIsNotCounted) {
  const InstructionCount count;
  const auto start = count.read();
  turns(100'000);
  const auto once = count.read();
  turns(200'000);
  const auto thrice = count.read();
  ASSERT_EQ(start.has_value(), once.has_value());
  ASSERT_EQ(start.has_value(), thrice.has_value());
  if (!start) GTEST_SKIP() << "this machine counts no instructions";
  const auto one = static_cast<double>(*once - *start), two = static_cast<double>(*thrice - *once);
  EXPECT_GE(one, 300'000);
  EXPECT_NEAR(two / one, 2, 0.01);
}

}  // namespace
}  // namespace flatray
