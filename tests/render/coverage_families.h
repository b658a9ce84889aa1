#pragma once
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "base/philox.h"
#include "geom/predicates.h"
#include "oracle/exact_coverage.h"
#include "render/scan_region.h"

namespace flatray::coverage_check {

/// A region both as the engine takes it and as the oracle does.
struct RegionCase {
  FillPath path;
  std::vector<std::vector<Vec2>> pieces;
};

enum class Family { random, sliver, decimal, corner, far, overlap, even_odd, deep };
inline constexpr std::array kFamilies{Family::random,   Family::sliver, Family::decimal,
                                      Family::corner,   Family::far,    Family::overlap,
                                      Family::even_odd, Family::deep};
inline const char* name(Family family) {
  constexpr std::array kNames{"random", "sliver",  "decimal",  "corner",
                              "far",    "overlap", "even_odd", "deep"};
  return kNames[static_cast<std::size_t>(family)];
}

/// Regions of a family among `count` of all: deep ones cost the oracle a hundred times the others.
inline std::uint64_t share_of(Family family, std::uint64_t count) {
  const std::uint64_t each = (count + kFamilies.size() - 1) / kFamilies.size();
  return family == Family::deep ? (each + 99) / 100 : each;
}

inline constexpr PixelBox kFrame{0, 0, 9, 9};

class Draws {
 public:
  Draws(std::uint64_t seed, std::uint64_t item) : seed_(seed), item_(item) {}
  std::uint64_t bits() { return random_bits(seed_, Stream::test, 0, item_, draw_++); }
  double unit() { return unit_double(bits()); }
  int below(int n) { return static_cast<int>(bits() % static_cast<std::uint64_t>(n)); }

 private:
  std::uint64_t seed_, item_;
  std::uint32_t draw_ = 0;
};

// Andrew's monotone chain with exact turns: strictly convex, counter-clockwise by the formula.
inline std::vector<Vec2> hull(std::vector<Vec2> points) {
  const auto before = [](const Vec2& a, const Vec2& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<Vec2> out;
  for (int side = 0; side < 2; ++side) {
    const std::size_t start = out.size();
    for (const Vec2& p : points) {
      while (out.size() >= start + 2 &&
             orientation(out[out.size() - 2], out.back(), p) != Sign::positive)
        out.pop_back();
      out.push_back(p);
    }
    out.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return out;
}

inline Vec2 point(Family family, Draws& draws) {
  const auto coordinate = [&] {
    switch (family) {
      case Family::decimal:
        return (draws.below(110) - 10) / 10.0;
      case Family::corner:
        return draws.below(3) == 0 ? draws.below(44) / 4.0 - 1 : draws.below(11) - 1.0;
      case Family::far:
        return draws.below(3) == 0 ? (draws.unit() - 0.5) * 4e6 : draws.unit() * 11 - 1;
      default:
        return draws.unit() * 11 - 1;
    }
  };
  const double x = coordinate();
  return {x, coordinate()};
}

inline std::vector<Vec2> convex(Family family, Draws& draws) {
  for (;;) {
    std::vector<Vec2> points;
    const int count = 3 + draws.below(5);
    for (int i = 0; i < count; ++i) points.push_back(point(family, draws));
    if (family == Family::sliver) {
      const double width = std::ldexp(1.0, -11 - draws.below(40));
      const Vec2 a = points[0], along = points[1] - a;
      for (Vec2& p : points)
        p = a + draws.unit() * along + width * Vec2(draws.unit() - 0.5, draws.unit() - 0.5);
    }
    std::vector<Vec2> ring = hull(std::move(points));
    if (ring.size() >= 3) return ring;
  }
}

inline void add_ring(const std::vector<Vec2>& ring, bool reversed, FillPath& path) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
    path.edges.push_back(reversed ? Segment{b, a} : Segment{a, b});
  }
}

/// The path of one ring.
inline FillPath ring_path(const std::vector<Vec2>& ring, bool simple = true) {
  FillPath path;
  add_ring(ring, false, path);
  path.simple = simple;
  return path;
}
inline FillPath box_path(double x0, double y0, double x1, double y1) {
  return ring_path({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
}

// A crossing ring by even-odd is the symmetric difference of the triangles from its first vertex.
inline RegionCase crossing_region(Draws& draws) {
  constexpr std::array kKinds{Family::random, Family::decimal, Family::corner, Family::far};
  const Family kind = kKinds[static_cast<std::size_t>(draws.below(4))];
  RegionCase region;
  std::vector<Vec2> ring;
  const int count = 4 + draws.below(5);
  for (int i = 0; i < count; ++i) ring.push_back(point(kind, draws));
  add_ring(ring, false, region.path);
  region.path.rule = FillRule::even_odd;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i)
    region.pieces.push_back({ring[0], ring[i], ring[i + 1]});
  return region;
}

inline RegionCase make_region(Family family, std::uint64_t seed, std::uint64_t item) {
  Draws draws(seed, item * kFamilies.size() + static_cast<std::uint64_t>(family));
  if (family == Family::even_odd) return crossing_region(draws);
  RegionCase region;
  const bool reversed = draws.below(2) == 0;
  const int pieces = family == Family::overlap ? 2 + draws.below(4)
                     : family == Family::deep  ? 9 + draws.below(4)
                                               : 1;
  const Family kind = pieces > 1 ? kFamilies[static_cast<std::size_t>(draws.below(5))] : family;
  for (int i = 0; i < pieces; ++i) {
    region.pieces.push_back(convex(kind, draws));
    add_ring(region.pieces.back(), reversed, region.path);
  }
  region.path.simple = pieces == 1;
  return region;
}

inline double exact_steps(const RegionCase& region, int x, int y) {
  Rational steps = region.path.rule == FillRule::nonzero ? exact_union_area(region.pieces, x, y)
                                                         : exact_odd_area(region.pieces, x, y);
  steps *= kFullCoverage;
  return steps.nearest();
}

/// What a run of a family showed; errors in steps.
struct Tally {
  std::uint64_t polygons = 0, pixels = 0, mismatches = 0;
  double worst = 0;
  std::string first_mismatch;
};

/// Half a step, as steps are whole, and what a float and the area in doubles are off by; where a pixel
/// may be crowded with edges that cross, as PixelArea has it for these.
inline double allowed(Family family) {
  return family == Family::deep ? 0.01 * kFullCoverage : 0.51;
}

inline void check_region(Family family, const RegionCase& region, const std::string& label,
                         Tally& tally) {
  const Steps steps = steps_of(region.path, kFrame);
  FillPath other = region.path;
  other.simple = false;
  const bool same = !region.path.simple || steps_of(other, kFrame) == steps;
  ++tally.polygons;
  for (int y = 0; y < kFrame.height; ++y)
    for (int x = 0; x < kFrame.width; ++x) {
      const double expected = exact_steps(region, x, y);
      const std::uint32_t actual = steps[static_cast<std::size_t>(y * kFrame.width + x)];
      ++tally.pixels;
      const double error = std::abs(actual - expected);
      tally.worst = std::max(tally.worst, error);
      if (error <= allowed(family) && same) continue;
      ++tally.mismatches;
      if (tally.first_mismatch.empty())
        tally.first_mismatch = fmt::format("{} pixel ({}, {}): {} steps, exact {}{}", label, x, y,
                                           actual, expected, same ? "" : ", simple flag matters");
    }
}

inline Tally run_family(Family family, std::uint64_t seed, std::uint64_t count) {
  Tally tally;
  for (std::uint64_t item = 0; item < count; ++item)
    check_region(family, make_region(family, seed, item),
                 fmt::format("{} {} seed {}", name(family), item, seed), tally);
  return tally;
}

inline std::string line(Family family, const Tally& t) {
  return fmt::format("{:9} {:7} polygons {:9} pixels compared {:3} mismatches, worst {:.3f} steps",
                     name(family), t.polygons, t.pixels, t.mismatches, t.worst);
}

}  // namespace flatray::coverage_check
