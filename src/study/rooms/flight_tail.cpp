#include "study/rooms/flight_tail.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"

namespace flatray {
namespace {

constexpr std::uint64_t kInGroup = 100;  // flights
constexpr double kLeastGroups = 30;
// There is a variance from 2 on, and standard errors are near their limit soon from 4 on.
constexpr double kLeastIndex = 4;

}  // namespace

void FlightTail::add(std::span<const double> longest, std::uint64_t flights) {
  const std::size_t orbits = (kInGroup + flights - 1) / flights;
  for (std::size_t i = 0; i + orbits <= longest.size(); i += orbits) {
    const double most =
        *std::max_element(longest.begin() + static_cast<std::ptrdiff_t>(i),
                          longest.begin() + static_cast<std::ptrdiff_t>(i + orbits));
    if (!(most > 0)) continue;
    const double log = portable::log(most);
    ++groups_;
    logs_ += log;
    squares_ += log * log;
  }
}

// The logarithm of the longest is Gumbel's: pi / sqrt(6) over its deviation is the index.
double FlightTail::index() const {
  if (groups_ < kLeastGroups) return 0;
  const double mean = logs_ / groups_;
  const double variance = std::max(squares_ / groups_ - mean * mean, 0.0);
  return 1.2825498301618641 / std::sqrt(variance);
}

std::string no_error_of_flights(const Room& room, const FlightTail& tail) {
  const auto& materials = room.materials();
  if (std::ranges::find(materials, Material::periodic) == materials.end()) return "";
  const double index = tail.index();
  if (index == 0) return "no error: too few flights to tell whether they have a variance";
  if (index >= kLeastIndex) return "";
  return fmt::format(
      "no error: flights longer than t fall like t^-{:.1f}, and have no variance that could be "
      "relied on",
      index);
}

void withhold_error_of_flights(Measure& mean, const Room& room, const FlightTail& tail) {
  const std::string why = no_error_of_flights(room, tail);
  if (!why.empty()) withhold_error(mean, why);
}

}  // namespace flatray
