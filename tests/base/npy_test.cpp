#include "base/npy.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <cstring>

namespace flatray {
namespace {

// The bytes that numpy.save writes for the same records, from its documentation of the format.
TEST(Npy, HoldsAHeadOfWholeLinesOfSixtyFourBytesAndTheBitsOfEachCell) {
  NpyTable table({{"orbit", NpyTable::Kind::whole}, {"sine", NpyTable::Kind::real}}, 2);
  table.add(std::uint64_t{1});
  table.add(-0.1);
  table.add(std::uint64_t{0x0102030405060708});
  table.add(0x1p-1074);
  const std::string bytes = std::move(table).take();
  ASSERT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x01\0", 8));
  const std::size_t head =
      static_cast<unsigned char>(bytes[8]) + 256U * static_cast<unsigned char>(bytes[9]);
  EXPECT_EQ((10 + head) % 64, 0U);
  const std::string words = bytes.substr(10, head);
  EXPECT_EQ(
      words.substr(0, words.find_last_not_of(" \n") + 1),
      "{'descr': [('orbit', '<u8'), ('sine', '<f8'), ], 'fortran_order': False, 'shape': (2,), }");
  EXPECT_EQ(words.back(), '\n');
  ASSERT_EQ(bytes.size(), 10 + head + 32);
  const auto word = [&](std::size_t i) {
    std::uint64_t value = 0;
    for (std::size_t k = 8; k-- > 0;)
      value = value << 8 | static_cast<unsigned char>(bytes[10 + head + 8 * i + k]);
    return value;
  };
  EXPECT_EQ(word(0), 1U);
  EXPECT_EQ(std::bit_cast<double>(word(1)), -0.1);
  EXPECT_EQ(bytes[10 + head + 16], 8) << "little end first";
  EXPECT_EQ(word(2), 0x0102030405060708U);
  EXPECT_EQ(std::bit_cast<double>(word(3)), 0x1p-1074);
}

TEST(Npy, AGridHasItsRowsAndColumnsInTheHead) {
  const std::uint64_t counts[] = {1, 2, 3, 4, 5, 6};
  const std::string bytes = npy_grid(counts, 2, 3);
  EXPECT_NE(bytes.find("{'descr': '<u8', 'fortran_order': False, 'shape': (2, 3), }"),
            std::string::npos);
  ASSERT_EQ(bytes.size() % 64, 48U);
  EXPECT_EQ(bytes[bytes.size() - 8], 6);
}

TEST(Npy, HeadsAreReadAsTheyWereWritten) {
  NpyTable table({{"orbit", NpyTable::Kind::whole}, {"sine", NpyTable::Kind::real}}, 0);
  const std::string none = std::move(table).take();
  const NpyHead of_table = head_of_npy(none);
  ASSERT_EQ(of_table.columns.size(), 2U);
  EXPECT_EQ(of_table.columns[1].name, "sine");
  EXPECT_EQ(of_table.columns[0].kind, NpyTable::Kind::whole);
  EXPECT_EQ(of_table.columns[1].kind, NpyTable::Kind::real);
  EXPECT_EQ(of_table.shape, std::vector<std::uint64_t>{0});
  EXPECT_EQ(of_table.size, none.size());
  const std::uint64_t counts[] = {1, 2, 3, 4, 5, 6};
  const NpyHead of_grid = head_of_npy(npy_grid(counts, 2, 3));
  EXPECT_TRUE(of_grid.columns.empty());
  EXPECT_EQ(of_grid.shape, (std::vector<std::uint64_t>{2, 3}));
}

}  // namespace
}  // namespace flatray
