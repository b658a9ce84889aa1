#pragma once
#include <cmath>
#include <cstdint>
#include <functional>
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
  int whole(int low, int high) { return low + static_cast<int>(below(high - low)); }
  double sign() { return unit() < 0.5 ? -1 : 1; }
  /// 2^low to 2^(high - 1); 1 to 2^(1 - n).
  double power(int low, int high) { return std::ldexp(1.0, whole(low, high)); }
  double halves(int n) { return std::ldexp(1.0, -whole(0, n)); }
  /// The same of either sign.
  double signed_halves(int n) {
    const double drawn = sign();
    return drawn * halves(n);
  }
  /// In the unit square; of whole numbers on [low, high).
  Vec2 point() {
    const double x = unit();
    return {x, unit()};
  }
  Vec2 whole_point(int low, int high) {
    const double x = whole(low, high);
    return {x, static_cast<double>(whole(low, high))};
  }
  template <class Items>
  const auto& any(const Items& items) {
    return items[static_cast<std::size_t>(below(static_cast<int>(std::size(items))))];
  }

 private:
  std::uint64_t seed_, family_, item_;
  std::uint32_t draw_ = 0;
};

/// The double itself, the one below or the one above, each as likely.
double nudge(double x, Draw& draw);
Vec2 nudge(const Vec2& v, Draw& draw);

/// A point of a curve, but for rounding, and the direction of its tangent there.
struct OnCurve {
  Vec2 at, tangent;
};

/// Walls, and rays aimed at what is hard about them.
struct AimedScene {
  std::vector<Segment> walls;
  std::vector<Ray> rays{};
  std::vector<Arc> curves{};
  std::vector<Bezier> beziers{};               ///< numbered last
  std::vector<std::vector<OnCurve>> places{};  ///< of Bezier curves, at which rays are aimed
  bool curves_first = false;  ///< numbered before the straight walls, else after them

  /// Whole circles as circles and, every second one, as arcs.
  Surfaces surfaces() const;
};

/// What a scene is put through, point by point; half-diameters are not where it moves all.
struct Move {
  std::function<Vec2(const Vec2&)> place;
  bool moves_all = false;
};

/// A kind of input on which plain doubles fail: see goal R1.
struct Family {
  const char* name;     ///< a word, as options say it
  const char* summary;  ///< one line, no full stop
  AimedScene (*walls)(Draw& draw);
  Ray (*ray)(const AimedScene& scene, Draw& draw);
  Move (*move)(Draw& draw) = nullptr;  ///< drawn first
};

/// Polygons of 3 to 6 edges in a scene, and rays.
inline constexpr int kPolygonsAScene = 16, kRaysAScene = 64;

/// All families, in the order of their numbers; those of them with straight walls, with circles, arcs
/// and ellipses, with Bezier curves, with curves of every size beside segments.
std::span<const Family> families();
std::vector<Family> wall_families();
std::vector<Family> arc_families();
std::vector<Family> bezier_families();
std::vector<Family> mixed_families();

/// Whole coordinates of scenes are about [0, kWorld).
inline constexpr int kWorld = 32;

/// Places of a family are moved by a factor of 2^-900 to 2^899, or flattened by up to 2^(1 - n).
Move scaled(Draw& draw);
Move moved_by(const Vec2& way);
Move flattened(double thin);

/// The scene of a number, the same for ever.
AimedScene make_scene(const Family& family, std::uint64_t seed, std::uint64_t item);
AimedScene make_scene(const Family& family, Draw& draw);

}  // namespace flatray::oracle
