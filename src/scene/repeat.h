#pragma once
#include <variant>

#include "scene/keys/builder.h"

namespace flatray {

/// Copies in rows: x first, then y.
struct Grid {
  std::uint64_t columns = 1, rows = 1;
  Vec2 step{0, 0};
};
/// Copies on a circle about `at`.
struct Ring {
  std::uint64_t count = 1;
  double radius = 0;
  double start = 0;            ///< degrees: direction of the first copy
  std::optional<double> step;  ///< degrees from one to the next; unset: 360 / count
  bool turn = false;           ///< whether each is turned to look outward
};
/// Copies at random places of a box.
struct Scatter {
  std::uint64_t count = 1;
  Bounds in;
};
using Repeat = std::variant<Grid, Ring, Scatter>;

/// Reads `{ grid = { ... } }`, `{ ring = { ... } }` or `{ scatter = { ... } }`; nullopt where it is
/// wrong.
std::optional<Repeat> read_repeat(Builder& builder, const Field& field);

/// A count too large to be told; sums and products of counts stop here.
inline constexpr std::uint64_t kUncounted = ~std::uint64_t{0};
inline std::uint64_t saturating_product(std::uint64_t a, std::uint64_t b) {
  return a != 0 && b > kUncounted / a ? kUncounted : a * b;
}

/// Number of copies; saturates.
std::uint64_t copy_count(const Repeat& repeat);

/// Where a copy stands relative to the one there would be.
struct Copy {
  Vec2 at{0, 0};
  double angle = 0;  ///< radians
};
/// Needs   `draws` set to the copy, where the repeat scatters.
Copy copy_of(const Repeat& repeat, std::uint64_t number, const Draws& draws);

std::vector<TableInfo> repeat_tables();

}  // namespace flatray
