#include "oracle/whole.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace flatray::oracle {
namespace {

constexpr int kMostBits = 60;

UInt128 size_of(Int128 x) { return x < 0 ? -static_cast<UInt128>(x) : static_cast<UInt128>(x); }

// Bits of |x|: 0 for 0.
int bits_of(UInt128 x) {
  const auto high = static_cast<std::uint64_t>(x >> 64), low = static_cast<std::uint64_t>(x);
  return high != 0 ? 128 - std::countl_zero(high) : 64 - std::countl_zero(low);
}

// 256 bits of a product.
struct Product {
  UInt128 high, low;
  auto operator<=>(const Product&) const = default;
};

Product product(UInt128 a, UInt128 b) {
  constexpr UInt128 mask = ~std::uint64_t{0};
  const UInt128 a1 = a >> 64, a0 = a & mask, b1 = b >> 64, b0 = b & mask;
  const UInt128 low = a0 * b0, left = a1 * b0, right = a0 * b1;
  const UInt128 middle = (low >> 64) + (left & mask) + (right & mask);
  return {a1 * b1 + (left >> 64) + (right >> 64) + (middle >> 64), (middle << 64) | (low & mask)};
}

// The exponent of the last bit of x that is set. Needs x != 0.
int last_bit(double x) {
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  const auto digits = static_cast<std::uint64_t>(std::fabs(std::ldexp(fraction, 53)));
  return exponent - 53 + std::countr_zero(digits);
}

}  // namespace

std::optional<Whole> whole_numbers(std::span<const double> doubles) {
  int lowest = 2000;
  double largest = 0;
  for (const double x : doubles) {
    if (x != 0) lowest = std::min(lowest, last_bit(x));
    largest = std::max(largest, std::fabs(x));
  }
  Whole whole;
  if (largest != 0) {
    if (std::ilogb(largest) - lowest + 1 > kMostBits) return std::nullopt;
    whole.exponent = lowest;
  }
  for (const double x : doubles)
    whole.numbers.push_back(static_cast<std::int64_t>(std::ldexp(x, -whole.exponent)));
  return whole;
}

std::strong_ordering Fraction::operator<=>(const Fraction& b) const {
  const int sign_a = numerator < 0 ? -1 : numerator > 0,
            sign_b = b.numerator < 0 ? -1 : b.numerator > 0;
  if (sign_a != sign_b) return sign_a <=> sign_b;
  const Product left = product(size_of(numerator), size_of(b.denominator));
  const Product right = product(size_of(b.numerator), size_of(denominator));
  return sign_a < 0 ? right <=> left : left <=> right;
}

// Long division: 54 bits and what is left over, so that the last one stands for the half.
double Fraction::nearest() const {
  if (numerator == 0) return 0;
  UInt128 rest = size_of(numerator), divisor = size_of(denominator);
  int exponent = bits_of(rest) - bits_of(divisor);  // of the first bit, or one too high
  if (exponent > 0)
    divisor <<= exponent;
  else
    rest <<= -exponent;
  if (rest < divisor) {
    rest <<= 1;
    --exponent;
  }
  std::uint64_t digits = 0;
  for (int i = 0; i < 54; ++i) {
    digits <<= 1;
    if (rest >= divisor) {
      rest -= divisor;
      digits |= 1;
    }
    rest <<= 1;
  }
  const bool half = (digits & 1) != 0;
  digits >>= 1;
  if (half && (rest != 0 || (digits & 1) != 0)) ++digits;
  const double value = std::ldexp(static_cast<double>(digits), exponent - 52);
  return numerator < 0 ? -value : value;
}

}  // namespace flatray::oracle
