#include "image/pfm.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

namespace flatray {
namespace {

const LinearImage kFloats{
    2, 2, {1, -2.5F, 1e-40F, 3e38F, 0, 7, std::numeric_limits<float>::infinity(), 1, 1, 8, 9, 10}};

TEST(Pfm, HoldsEveryFloatFromTheLowestRowUp) {
  const auto bytes = encode_pfm(kFloats);
  const std::string head = "PF\n2 2\n-1.0\n";
  ASSERT_EQ(bytes.size(), head.size() + 48);
  EXPECT_EQ(std::string(reinterpret_cast<const char*>(bytes.data()), head.size()), head);
  float first = 0;  // of the second row
  std::memcpy(&first, &bytes[head.size() + 4], sizeof first);
  EXPECT_EQ(first, 1);
  const auto read = decode_pfm(bytes, "x.pfm");
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->pixels, kFloats.pixels);
}

TEST(Pfm, OfAnotherSizeOrKindIsRefused) {
  auto bytes = encode_pfm(kFloats);
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(decode_pfm(std::span(bytes).first(size), "x.pfm")) << size;
  for (const char* head : {"PF\n2147483647 2147483647\n-1.0\n", "PF\n0 0\n-1.0\n", "PF\n2 2\n1.0\n",
                           "Pf\n2 2\n-1.0\n", "PF\n-2 2\n-1.0\n", "PF\n2 +2\n-1.0\n"})
    EXPECT_FALSE(decode_pfm(std::as_bytes(std::span(std::string_view(head))), "x.pfm")) << head;
}

}  // namespace
}  // namespace flatray
