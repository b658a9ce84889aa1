#pragma once
#include <cmath>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "base/philox.h"
#include "trace/surfaces.h"

namespace flatray::oracle {

/// Draws of one scene, one after the other. Two in the arguments of one call, or on two sides of an
/// operator, have no order that compilers agree on; between braces they have.
class Draw {
 public:
  Draw(std::uint64_t seed, std::uint64_t family, std::uint64_t item)
      : seed_(seed), family_(family), item_(item) {}
  /// On [0, 1).
  double unit() { return unit_double(random_bits(seed_, Stream::test, family_, item_, draw_++)); }
  /// A whole number on [0, n).
  double below(int n) { return std::floor(unit() * n); }
  double sign() { return unit() < 0.5 ? -1 : 1; }

 private:
  std::uint64_t seed_, family_, item_;
  std::uint32_t draw_ = 0;
};

/// The double itself, the one below or the one above, each as likely.
double nudge(double x, Draw& draw);
Vec2 nudge(const Vec2& v, Draw& draw);

/// Walls, and rays aimed at what is hard about them.
struct AimedScene {
  std::vector<Segment> walls;
  std::vector<Ray> rays;
  std::vector<Arc> curves;
  std::vector<std::vector<Vec2>> beziers{};  ///< control points; numbered last
  bool curves_first = false;  ///< numbered before the straight walls, else after them

  /// Whole circles as circles and, every second one, as arcs.
  Surfaces surfaces() const;
};

/// A kind of input on which plain doubles fail: see goal R1.
struct Family {
  const char* name;     ///< a word, as options say it
  const char* summary;  ///< one line, no full stop
  AimedScene (*make)(Draw& draw);
};

/// Polygons of 3 to 6 edges in a scene, and rays.
inline constexpr int kPolygonsAScene = 16, kRaysAScene = 64;

/// All families, in the order of their numbers.
std::span<const Family> families();

/// The scene of a number, the same for ever.
AimedScene make_scene(const Family& family, std::uint64_t seed, std::uint64_t item);

}  // namespace flatray::oracle
