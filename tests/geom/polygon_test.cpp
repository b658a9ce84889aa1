#include "geom/polygon.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/philox.h"
#include "base/portable_math.h"
#include "geom/exact.h"
#include "geom/outline.h"

namespace flatray {
namespace {

using Ring = std::vector<Vec2>;
constexpr double kPi = 3.14159265358979323846;

double draw_coordinate(std::uint64_t item, std::uint32_t k) {
  return unit_double(random_bits(7, Stream::test, 0, item, k));
}

Ring regular(int n, double radius = 1) {
  Ring ring;
  for (int i = 0; i < n; ++i)
    ring.push_back(
        {radius * portable::cos(2 * kPi * i / n), radius * portable::sin(2 * kPi * i / n)});
  return ring;
}

Ring reversed(Ring ring) {
  std::reverse(ring.begin(), ring.end());
  return ring;
}

Rational twice_area(std::span<const Vec2> ring) {
  Rational sum;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
    sum += Rational(a.x()) * b.y() - Rational(b.x()) * a.y();
  }
  return sum;
}

TEST(StiffCases, B10BowTieIsNotConvexAndItsCrossingEdgesAreNamed) {
  const Ring bow_tie = {{0, 0}, {1, 1}, {1, 0}, {0, 1}};
  EXPECT_TRUE(non_convex_vertex(bow_tie));
  const auto crossing = crossing_edges(bow_tie);
  ASSERT_TRUE(crossing);
  EXPECT_EQ(crossing->first, 0u);
  EXPECT_EQ(crossing->second, 2u);
  EXPECT_EQ(ring_orientation(bow_tie), Sign::zero);
}

TEST(StiffCases, B12ManyGonIsConvex) {
  const Ring ring = regular(1'000'000);
  EXPECT_FALSE(non_convex_vertex(ring));
  EXPECT_EQ(ring_orientation(ring), Sign::positive);
}

TEST(NonConvexVertex, NamesTheReflexVertexInEitherOrientation) {
  const Ring dart = {{0, 0}, {2, -1}, {1, 0}, {2, 1}};
  EXPECT_EQ(non_convex_vertex(dart), 2u);
  EXPECT_EQ(non_convex_vertex(reversed(dart)), 1u);
}

TEST(NonConvexVertex, RefusesARingThatWindsTwice) {
  Ring pentagram;
  const Ring five = regular(5);
  for (std::size_t i = 0; i < 5; ++i) pentagram.push_back(five[2 * i % 5]);
  EXPECT_TRUE(non_convex_vertex(pentagram));
  Ring twice = five;
  twice.insert(twice.end(), five.begin(), five.end());
  EXPECT_TRUE(non_convex_vertex(twice));
}

TEST(NonConvexVertex, PassesOverRepeatedAndCollinearVertices) {
  EXPECT_FALSE(non_convex_vertex(
      Ring{{0, 0}, {0, 0}, {0.5, 0}, {1, 0}, {1, 1}, {1, 1}, {1, 1}, {0, 1}, {0, 0.25}, {0, 0}}));
  EXPECT_FALSE(non_convex_vertex(Ring{{1, 1}, {1, 1}, {1, 1}}));
  EXPECT_FALSE(non_convex_vertex(Ring{{0, 0}, {2, 2}, {1, 1}}));
}

TEST(NonConvexVertex, RefusesASpike) {
  EXPECT_TRUE(non_convex_vertex(Ring{{0, 0}, {3, 0}, {1, 0}, {1, 1}}));
}

TEST(NonConvexVertex, OneUlpInwardIsSeen) {
  Ring square = {{0, 0}, {1, 0}, {1, 0.5}, {1, 1}, {0, 1}};
  EXPECT_FALSE(non_convex_vertex(square));
  square[2].x() = 1 - 0x1p-53;
  EXPECT_EQ(non_convex_vertex(square), 2u);
}

// Corners on a circle, in either orientation, far away: some come to lie inside of others.
TEST(MendConvex, GivesTheHullOfRoundedCornersWithAsManyEdges) {
  std::size_t moved = 0;
  for (int n = 3; n < 120; n += 3)
    for (const double far : {0.0, 0x1p48, 0x1p50, -0x1p51})
      for (const double way : {1.0, -1.0}) {
        std::vector<Vec2> given, rounded;
        for (int i = 0; i < n; ++i) {
          const double angle = way * 2 * std::numbers::pi * (i + 0.1) / n;
          given.emplace_back(std::cos(angle) + (far + 1), std::sin(angle) - far);
        }
        rounded = given;
        mend_convex(rounded);
        ASSERT_EQ(rounded.size(), given.size());
        EXPECT_FALSE(non_convex_vertex(rounded)) << n << " at " << far;
        for (int i = 0; i < n; ++i) {
          const auto k = static_cast<std::size_t>(i);
          moved += rounded[k] != given[k] ? 1 : 0;
          const Vec2 &a = rounded[k], &b = rounded[(k + 1) % rounded.size()];
          for (const Vec2& corner : given)
            EXPECT_NE(orientation(a, b, corner), way > 0 ? Sign::negative : Sign::positive)
                << n << " at " << far;
        }
      }
  EXPECT_GT(moved, 1000U);
}

TEST(CrossingEdges, ASimpleRingHasNone) {
  EXPECT_FALSE(crossing_edges(regular(1000)));
  EXPECT_FALSE(crossing_edges(Ring{{0, 0}, {0, 0}, {1, 0}, {2, 0}, {1, 1}, {0, 0}}));
}

TEST(CrossingEdges, TouchingIsCrossing) {
  // Vertex 3 lies on edge 0; then the same a hair above it.
  EXPECT_TRUE(crossing_edges(Ring{{0, 0}, {4, 0}, {4, 2}, {2, 0}, {0, 2}}));
  EXPECT_FALSE(crossing_edges(Ring{{0, 0}, {4, 0}, {4, 2}, {2, 5e-324}, {0, 2}}));
  EXPECT_TRUE(crossing_edges(Ring{{0, 0}, {3, 0}, {1, 0}, {1, 1}}));  // folds back at vertex 1
  EXPECT_TRUE(crossing_edges(Ring{{0, 0}, {1, 0}}));
  EXPECT_TRUE(crossing_edges(Ring{{0, 0}, {2, 1}, {4, 0}, {4, 2}, {2, 1}, {0, 2}}));  // at a vertex
}

// The edges named do meet: those of every pair on the grid, and of a long ring one far from the
// rest.
TEST(CrossingEdges, NamesAPairThatMeets) {
  Ring ring;
  for (int k = 0; k < 500; ++k)
    ring.push_back({static_cast<double>(k), static_cast<double>(k % 2)});
  ring.push_back({499, 5});
  for (int k = 499; k-- > 0;)
    ring.push_back({static_cast<double>(k), 3 + static_cast<double>(k % 2)});
  ASSERT_FALSE(crossing_edges(ring));
  ring[251] = {250.9, 4.5};
  const auto crossing = crossing_edges(ring);
  ASSERT_TRUE(crossing);
  EXPECT_TRUE(crossing->first == 250 || crossing->first == 251) << crossing->first;
  EXPECT_GT(crossing->second, 500U);
}

bool segments_meet(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  // In parameters of both: a + s (b - a) = c + t (d - c), solved in rationals; small integers only.
  const Vec2 u = b - a, v = d - c, w = c - a;
  const double det = cross(u, v);
  if (det != 0) {
    const double s = cross(w, v), t = cross(w, u), sign = det > 0 ? 1 : -1;
    return s * sign >= 0 && s * sign <= det * sign && t * sign >= 0 && t * sign <= det * sign;
  }
  if (cross(u, w) != 0) return false;
  const double c_at = u.dot(w), d_at = u.dot(Vec2(d - a));  // along u, in units of 1 / |u|
  return std::max(c_at, d_at) >= 0 && std::min(c_at, d_at) <= u.dot(u);
}

TEST(CrossingEdges, AgreesWithEveryPairOnTheGrid) {
  int crossing = 0;
  for (std::uint64_t i = 0; i < 3000; ++i) {
    Ring ring;
    const int n = 4 + static_cast<int>(i % 6);
    for (std::uint32_t k = 0; static_cast<int>(ring.size()) < n; ++k) {
      const Vec2 p(std::floor(6 * draw_coordinate(i, 2 * k)),
                   std::floor(6 * draw_coordinate(i, 2 * k + 1)));
      if (std::find(ring.begin(), ring.end(), p) == ring.end()) ring.push_back(p);
    }
    bool expected = false;
    const auto at = [&](int k) { return ring[static_cast<std::size_t>(k % n)]; };
    for (int a = 0; a < n; ++a) {
      for (int b = a + 2; b < n; ++b)
        if (b - a < n - 1) expected |= segments_meet(at(a), at(a + 1), at(b), at(b + 1));
      const Vec2 u = at(a + 1) - at(a), v = at(a + 2) - at(a + 1);
      expected |= cross(u, v) == 0 && u.dot(v) < 0;
    }
    EXPECT_EQ(crossing_edges(ring).has_value(), expected) << i;
    crossing += expected ? 1 : 0;
  }
  EXPECT_GT(crossing, 500);
  EXPECT_LT(crossing, 2900);
}

// What every cutting must keep: convex counter-clockwise pieces of the ring's vertices, its whole
// area, each edge of positive length once, and each cut seen from two sides.
void check_pieces(const Ring& ring) {
  const ConvexPieces pieces = convex_pieces(ring);
  ASSERT_EQ(pieces.vertices.size(), pieces.edges.size());
  Rational area;
  std::vector<int> seen(ring.size(), 0);
  std::vector<std::array<double, 4>> cuts, back;
  for (std::size_t i = 0; i + 1 < pieces.begin.size(); ++i) {
    const std::span<const Vec2> piece(&pieces.vertices[pieces.begin[i]],
                                      pieces.begin[i + 1] - pieces.begin[i]);
    ASSERT_FALSE(non_convex_vertex(piece));
    ASSERT_EQ(ring_orientation(piece), Sign::positive);
    area += twice_area(piece);
    for (std::size_t k = 0; k < piece.size(); ++k) {
      const std::int32_t edge = pieces.edges[pieces.begin[i] + k];
      const Vec2 &a = piece[k], &b = piece[(k + 1) % piece.size()];
      if (edge < 0) {
        cuts.push_back({a.x(), a.y(), b.x(), b.y()});
        back.push_back({b.x(), b.y(), a.x(), a.y()});
        continue;
      }
      const auto e = static_cast<std::size_t>(edge);
      const Vec2 &p = ring[e], &q = ring[(e + 1) % ring.size()];
      EXPECT_TRUE((a == p && b == q) || (a == q && b == p));
      ++seen[e];
    }
  }
  const Rational whole = twice_area(ring);
  EXPECT_EQ(area, whole.sign() == Sign::negative ? -whole : whole);
  for (std::size_t e = 0; e < ring.size(); ++e)
    EXPECT_EQ(seen[e], ring[e] == ring[(e + 1) % ring.size()] ? 0 : 1) << "edge " << e;
  std::sort(cuts.begin(), cuts.end());
  std::sort(back.begin(), back.end());
  EXPECT_EQ(cuts, back);
}

TEST(ConvexPieces, AConvexRingIsOnePieceWithItsEdges) {
  const ConvexPieces pieces = convex_pieces(Ring{{0, 1}, {1, 1}, {1, 0}, {0.5, 0}, {0, 0}, {0, 0}});
  EXPECT_EQ(pieces.begin, (std::vector<std::uint32_t>{0, 5}));
  check_pieces(Ring{{0, 1}, {1, 1}, {1, 0}, {0.5, 0}, {0, 0}, {0, 0}});
}

TEST(ConvexPieces, AnLIsTwoPieces) {
  EXPECT_EQ(convex_pieces(Ring{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}).begin.size(), 3u);
}

// A star-shaped ring on a coarse grid of radii has flat corners, collinear triples and needles.
TEST(ConvexPieces, KeepAreaAndEdgesOfStars) {
  for (std::uint64_t i = 0; i < 300; ++i) {
    Ring ring;
    const int n = 5 + static_cast<int>(i % 40);
    const Ring directions = regular(n);
    for (int k = 0; k < n; ++k)
      ring.push_back((1 + std::floor(4 * draw_coordinate(i, static_cast<std::uint32_t>(k)))) *
                     directions[static_cast<std::size_t>(k)]);
    if (crossing_edges(ring)) continue;
    check_pieces(i % 2 == 0 ? ring : reversed(ring));
  }
}

// A rectilinear ring: columns of random integer heights on both sides, with repeated and flat
// vertices.
TEST(ConvexPieces, KeepAreaAndEdgesOfSkylines) {
  for (std::uint64_t i = 0; i < 200; ++i) {
    Ring ring;
    const int n = 2 + static_cast<int>(i % 20);
    for (int k = 0; k < n; ++k) {
      const double h = -1 - std::floor(3 * draw_coordinate(i, static_cast<std::uint32_t>(k)));
      ring.push_back({static_cast<double>(k), h});
      ring.push_back({static_cast<double>(k + 1), h});
    }
    for (int k = n; k-- > 0;) {
      const double h = 1 + std::floor(3 * draw_coordinate(i, static_cast<std::uint32_t>(100 + k)));
      ring.push_back({static_cast<double>(k + 1), h});
      ring.push_back({static_cast<double>(k), h});
    }
    check_pieces(ring);
  }
}

// Rings that grow by one point of a coarse grid at a time, wherever they stay simple: upright edges,
// flat corners, vertices in one line and in one column.
TEST(ConvexPieces, KeepAreaAndEdgesOfRingsGrownOnAGrid) {
  for (std::uint64_t i = 0; i < 100; ++i) {
    Ring ring = {{0, 0}, {8, 0}, {0, 8}};
    for (std::uint32_t k = 0; k < 80; ++k) {
      Ring longer = ring;
      const auto at =
          static_cast<std::ptrdiff_t>(draw_coordinate(i, 3 * k) * static_cast<double>(ring.size()));
      longer.insert(longer.begin() + at, Vec2(std::floor(12 * draw_coordinate(i, 3 * k + 1)),
                                              std::floor(12 * draw_coordinate(i, 3 * k + 2))));
      if (!crossing_edges(longer)) ring = std::move(longer);
    }
    ASSERT_GT(ring.size(), 8U);
    check_pieces(i % 2 == 0 ? ring : reversed(ring));
  }
}

TEST(ConvexPieces, ASpiralOfTenThousandVerticesIsCut) {
  Ring ring;
  const int n = 5000;
  for (int k = 0; k < n; ++k) {
    const double angle = 40 * kPi * k / n, radius = 1 + angle;
    ring.push_back({radius * portable::cos(angle), radius * portable::sin(angle)});
  }
  for (int k = n; k-- > 0;) {
    const double angle = 40 * kPi * k / n, radius = 3 + angle;
    ring.push_back({radius * portable::cos(angle), radius * portable::sin(angle)});
  }
  ASSERT_FALSE(crossing_edges(ring));
  check_pieces(ring);
}

// Squares of a grid about 0 whose zeros have either sign: what is left of their 1600 edges is the border,
// in the order of the squares.
TEST(OutlineEdges, OfAGridAreItsBorderWhateverTheSignsOfZeros) {
  constexpr int kHalf = 10;
  std::vector<Vec2> points;
  std::vector<std::uint32_t> to;
  std::vector<bool> on_border;
  const auto coordinate = [&](int at) {
    return at == 0 && points.size() % 3 == 0 ? -0.0 : static_cast<double>(at);
  };
  for (int x = -kHalf; x < kHalf; ++x)
    for (int y = -kHalf; y < kHalf; ++y)
      for (int edge = 0; edge < 4; ++edge) {
        const int from_x = x + (edge == 1 || edge == 2 ? 1 : 0), from_y = y + edge / 2;
        const auto here = static_cast<std::uint32_t>(points.size());
        points.push_back({coordinate(from_x), coordinate(from_y)});
        to.push_back(edge == 3 ? here - 3 : here + 1);
        const int outer[] = {y, x + 1, y + 1, x}, limit[] = {-kHalf, kHalf, kHalf, -kHalf};
        on_border.push_back(outer[edge] == limit[edge]);
      }
  std::vector<std::uint32_t> border;
  for (std::uint32_t i = 0; i < to.size(); ++i)
    if (on_border[i]) border.push_back(i);
  EXPECT_EQ(border.size(), 8U * kHalf);
  EXPECT_EQ(outline_edges(points, to), border);
}

}  // namespace
}  // namespace flatray
