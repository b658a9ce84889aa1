#include "study/rooms/starts.h"

#include "base/philox.h"

namespace flatray {
namespace {

// 2^64 / p and 2^64 / p^2, rounded.
constexpr std::uint64_t kStepX = 0xc13fa9a902a6328f, kStepY = 0x91e10da5c79e7b1d;
// No start has this number, so no draw of one is named like a shift.
constexpr std::uint64_t kNoStart = 0xffffffff;

}  // namespace

UnitPoint quasi_point(std::uint64_t seed, std::uint64_t number) {
  const std::uint64_t shift = number % kShifts, n = number / kShifts;
  const auto moved = [&](std::uint32_t axis, std::uint64_t step) {
    return unit_double(random_bits(seed, Stream::experiment, kNoStart, shift, axis) + n * step);
  };
  return {moved(0, kStepX), moved(1, kStepY)};
}

double drawn_unit(std::uint64_t seed, std::uint64_t number, std::uint32_t which) {
  return unit_double(random_bits(seed, Stream::experiment, number >> 32, number, which));
}

Ray random_ray(const Bounds& window, std::uint64_t seed, std::uint64_t number) {
  const auto draw = [&](std::uint32_t which) {
    return unit_double(random_bits(seed, Stream::experiment, number, which));
  };
  return {window.low + Vec2(draw(0), draw(1)).cwiseProduct(window.size()),
          {draw(2) - 0.5, draw(3) - 0.5}};
}

void StartSums::add(std::uint64_t number, double x, double y) {
  sums_[number % sums_.size()].add(x, y);
}

RatioSums StartSums::all() const {
  if (starts_ == Starts::random) return sums_.front();
  double x = 0, y = 0;
  for (const RatioSums& shift : sums_) x += shift.x, y += shift.y;
  RatioSums all{.about = y != 0 ? x / y : 0};
  for (const RatioSums& shift : sums_) all.add(shift.x, shift.y);
  return all;
}

}  // namespace flatray
