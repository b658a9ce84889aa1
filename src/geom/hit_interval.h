#pragma once
#include <cstdint>

namespace flatray {

/// How a ray meets a closed shape (docs/GLOSSARY.md, class of a hit).
enum class HitClass : std::uint8_t {
  miss,
  touch,   ///< one point, or a point test on the boundary
  along,   ///< a stretch of positive length, all of it on the boundary
  through  ///< meets the interior
};

/// Where the origin of the ray lies.
enum class StartPlace : std::uint8_t { outside, boundary, inside };

inline constexpr int kNoEdge = -1;

/// Closed parameter range inside a convex shape; one point allowed.
///
/// Units   t counts lengths of the ray's direction.
/// Gives   t_enter > t_exit exactly when kind is miss. Edge i runs from vertex i to i + 1 of the
///         shape as given; kNoEdge where the interval ends with the range asked for, and where it
///         ends on a circle, an ellipse or a Bezier curve.
struct HitInterval {
  double t_enter = 1, t_exit = 0;
  int edge_enter = kNoEdge, edge_exit = kNoEdge;
  HitClass kind = HitClass::miss;
  StartPlace start = StartPlace::outside;
  bool enter_overflows = false,
       exit_overflows = false;  ///< t is beyond the doubles and is given as the largest

  explicit operator bool() const { return kind != HitClass::miss; }
  bool operator==(const HitInterval&) const = default;
};

const char* name(HitClass kind);
const char* name(StartPlace start);

}  // namespace flatray
