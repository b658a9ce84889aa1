// needs: encoders/own
#include "image/huffman.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/philox.h"

namespace flatray {
namespace {

using Counts = std::vector<std::uint32_t>;

std::vector<CodeWord> code_of(const Counts& counts, unsigned longest) {
  std::vector<CodeWord> code(counts.size());
  make_code(counts, longest, code);
  return code;
}

// All words of a complete code fill the room of the longest ones.
double room(const std::vector<CodeWord>& code) {
  double sum = 0;
  for (const CodeWord& word : code)
    if (word.bits > 0) sum += std::ldexp(1.0, -static_cast<int>(word.bits));
  return sum;
}

double cost(const Counts& counts, const std::vector<CodeWord>& code) {
  double bits = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) bits += double{counts[i] * 1.0} * code[i].bits;
  return bits;
}

Counts random_counts(std::size_t symbols, std::uint64_t seed, unsigned spread) {
  Counts counts(symbols);
  for (std::size_t i = 0; i < symbols; ++i) {
    const std::uint64_t bits = random_bits(seed, Stream::test, 1, i);
    counts[i] = static_cast<std::uint32_t>((bits >> 40) >> (bits % spread));
  }
  counts[0] += 1;
  return counts;
}

TEST(Huffman, CodesAreCompleteAndNoWordBeginsAnother) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const std::vector<CodeWord> code = code_of(random_counts(286, seed, 25), 12);
    EXPECT_EQ(room(code), 1.0);
    for (const CodeWord& a : code)
      for (const CodeWord& b : code) {
        if (&a == &b || a.bits == 0 || a.bits > b.bits) continue;
        ASSERT_NE(a.word, b.word & ((1U << a.bits) - 1));
      }
  }
}

TEST(Huffman, CostsLessThanABitASymbolMoreThanTheEntropy) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Counts counts = random_counts(200, seed, 8);
    double total = 0, entropy = 0;
    for (const std::uint32_t count : counts) total += count;
    for (const std::uint32_t count : counts)
      if (count > 0) entropy += count * std::log2(total / count);
    const double bits = cost(counts, code_of(counts, 15));
    EXPECT_GE(bits, entropy * (1 - 1e-12));
    EXPECT_LT(bits, entropy + total);
  }
}

// The deepest tree there is: each count the sum of the two before.
TEST(Huffman, FibonacciCountsKeepToTheLongestWord) {
  Counts counts = {1, 1};
  while (counts.size() < 40)
    counts.push_back(counts[counts.size() - 1] + counts[counts.size() - 2]);
  for (const unsigned longest : {6U, 7U, 12U, 15U}) {
    const std::vector<CodeWord> code = code_of(counts, longest);
    EXPECT_EQ(room(code), 1.0);
    for (const CodeWord& word : code) {
      EXPECT_GE(word.bits, 1U);
      EXPECT_LE(word.bits, longest);
    }
  }
}

TEST(Huffman, AnOnlySymbolGetsACompanion) {
  for (const std::size_t only : {0U, 1U, 29U}) {
    Counts counts(30);
    counts[only] = 7;
    const std::vector<CodeWord> code = code_of(counts, 12);
    EXPECT_EQ(code[only].bits, 1U);
    EXPECT_EQ(room(code), 1.0);
  }
}

}  // namespace
}  // namespace flatray
