#pragma once
#include <compare>
#include <cstdint>

namespace flatray {

enum class Sign : std::int8_t { negative = -1, zero = 0, positive = 1 };

constexpr Sign operator-(Sign s) { return static_cast<Sign>(-static_cast<int>(s)); }
constexpr Sign operator*(Sign a, Sign b) {
  return static_cast<Sign>(static_cast<int>(a) * static_cast<int>(b));
}
constexpr Sign sign_of(std::strong_ordering order) {
  return order > 0 ? Sign::positive : order < 0 ? Sign::negative : Sign::zero;
}
constexpr std::strong_ordering order(Sign s) { return static_cast<int>(s) <=> 0; }
constexpr Sign sign_of(double x) {
  return x > 0 ? Sign::positive : x < 0 ? Sign::negative : Sign::zero;
}

}  // namespace flatray
