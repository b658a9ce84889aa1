#include "transport/near_doubles.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

namespace flatray {
namespace {

constexpr int kSide = 2 * kSearchUlps + 1;
using Order = std::array<UlpSteps, kSide * kSide - 1>;

// Nearest first, where an ulp along each axis is as long as given; row by row where they tie.
constexpr Order by_distance(int x_ulp, int y_ulp) {
  Order all{};
  auto next = all.begin();
  for (int y = -kSearchUlps; y <= kSearchUlps; ++y)
    for (int x = -kSearchUlps; x <= kSearchUlps; ++x)
      if (x != 0 || y != 0) *next++ = {static_cast<std::int8_t>(x), static_cast<std::int8_t>(y)};
  const auto key = [&](const UlpSteps& step) {
    const int x = step.x * x_ulp, y = step.y * y_ulp;
    return (x * x + y * y) * kSide * kSide + (step.y + kSearchUlps) * kSide + step.x + kSearchUlps;
  };
  std::ranges::sort(all, {}, key);
  return all;
}

// Where one ulp is four times the other, or more, the longer steps decide first.
constexpr Order kOrders[] = {by_distance(1, 4), by_distance(1, 2), by_distance(1, 1),
                             by_distance(2, 1), by_distance(4, 1)};
static_assert(kSearchUlps < 4);

int exponent(double x) {
  return std::max(static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52U & 0x7ffU), 1);
}

}  // namespace

// The bits of doubles of one sign are in their order.
double step_ulps(double x, int ulps) {
  constexpr auto kNegative = std::numeric_limits<std::int64_t>::min();
  constexpr auto kLast = std::bit_cast<std::int64_t>(std::numeric_limits<double>::infinity());
  const auto bits = std::bit_cast<std::int64_t>(x);
  const std::int64_t place = std::clamp((bits < 0 ? kNegative - bits : bits) + ulps, -kLast, kLast);
  return std::bit_cast<double>(place < 0 ? kNegative - place : place);
}

std::span<const UlpSteps> steps_about(const Vec2& centre) {
  return kOrders[2 + std::clamp(exponent(centre.x()) - exponent(centre.y()), -2, 2)];
}

}  // namespace flatray
