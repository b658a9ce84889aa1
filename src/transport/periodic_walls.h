#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geom/ray.h"
#include "scene/outlines/lattice_cell.h"
#include "scene/scene.h"
#include "trace/surfaces.h"

namespace flatray {

/// A ray between periodic walls that crosses as many of them and meets nothing else never will, as
/// far as anyone can wait.
inline constexpr std::uint32_t kMostCrossings = 1U << 18;

/// Which copy of a periodic cell: how many times each of its two lattice vectors lies between it and
/// the cell as given.
struct CellIndex {
  std::int64_t a = 0, b = 0;

  CellIndex& operator+=(const CellIndex& step) {
    a += step.a;
    b += step.b;
    return *this;
  }
  CellIndex operator-(const CellIndex& from) const { return {a - from.a, b - from.b}; }
  bool operator==(const CellIndex&) const = default;
};

/// The walls of a cell that fills the plane by translations, of which opposite ones are the same: a
/// torus. A cell is a convex polygon of four or six edges whose corners lie opposite each other about
/// one point.
class PeriodicWalls {
 public:
  struct Side {
    std::uint32_t surface, opposite;
    Segment wall, far;  ///< counter-clockwise; that opposite
    CellIndex step;     ///< to the cell that lies beyond it
    int axis;           ///< across which it stands upright; -1 of a wall that is oblique

    /// What crossing it adds to a place is to() - from(), as exact numbers.
    const Vec2& from() const { return wall.a; }
    const Vec2& to() const { return far.b; }
  };
  /// The walls that are left by at once, in turn: two where a ray goes through a corner of the cell.
  using Crossed = std::vector<const Side*>;

  /// Needs   the periodic ones of `walls` to be the edges of one cell in order, or none. No materials
  ///         mean none.
  PeriodicWalls(const Surfaces& walls, std::span<const Material> materials);

  bool any() const { return !sides_.empty(); }
  /// nullptr of any other wall.
  const Side* find(std::uint32_t surface) const;
  bool has(std::uint32_t surface) const { return find(surface) != nullptr; }
  /// Whether a direction leads out of the cell by a wall; not along it. Exact.
  bool leads_out(std::uint32_t surface, const Vec2& direction) const;

  /// By which of the walls that a ray meets at once it leaves, and by which then in the corner that this
  /// leads to.
  ///
  /// Needs   leads_out(side) to say whether its direction does, nullopt where that cannot be told.
  template <class LeadsOut>
  std::optional<Crossed> crossed_by(std::span<const std::uint32_t> surfaces,
                                    const LeadsOut& leads_out) const;

  /// A disc that reaches over the walls.
  struct Disc {
    std::uint32_t surface;
    Circle circle;
    Bounds box;

    /// Exact.
    Sign side_of(const Vec2& point) const {
      return box.contains(point) ? curve_side(point, circle) : Sign::positive;
    }
  };
  /// One as it stands in a neighbouring cell: its centre is that of the
  /// surface `of` and a step of the lattice, as exact numbers; the surface's own is rounded.
  struct Copy {
    std::uint32_t surface, of;
    CellIndex step;
  };
  /// nullptr of any other wall.
  const Copy* find_copy(std::uint32_t surface) const;

  /// Where a ray that arrives at a point of some of them goes on.
  struct Entry {
    /// On the closed inner side of all walls of the cell, and outside all its discs but those that the ray
    /// stays in.
    Vec2 point;
    std::uint32_t surface;  ///< the wall it comes in by, the last one where it was in a corner
    CellIndex step;         ///< from the cell that it left
  };
  /// Gives   nothing where none of them leads out, or where no double within a few ulps will do.
  /// Error   of an upright wall the place along it exact; of others two ulps of the largest coordinate.
  std::optional<Entry> cross(const Vec2& point, const Vec2& direction,
                             std::span<const std::uint32_t> surfaces) const;

  /// Whether a point is on or in one of the discs that stand across its walls. Exact.
  bool in_disc_across(const Vec2& point) const;

  /// Its two lattice vectors, rounded once: where the cell of index (1, 0) lies, that of (0, 1).
  const std::array<Vec2, 2>& lattice() const { return rounded_; }
  /// A point as many cells on.
  Vec2 shifted(const Vec2& point, const CellIndex& by) const {
    return point + static_cast<double>(by.a) * rounded_[0] +
           static_cast<double>(by.b) * rounded_[1];
  }
  const Lattice& exact_lattice() const { return lattice_; }

 private:
  std::vector<bool> discs_around(const Vec2& point, const CellIndex& step) const;
  std::optional<Vec2> inside(const Vec2& place, const Segment& wall,
                             const std::vector<bool>& around) const;
  bool may_stand(const Vec2& point, const std::vector<bool>& around) const;

  std::vector<Side> sides_;  // in order round the cell
  Lattice lattice_{};
  std::array<Vec2, 2> rounded_{Vec2(0, 0), Vec2(0, 0)};
  std::vector<Disc> discs_;   // that reach over its walls, each with the copies that do
  std::vector<Copy> copies_;  // ascending
};

template <class LeadsOut>
std::optional<PeriodicWalls::Crossed> PeriodicWalls::crossed_by(
    std::span<const std::uint32_t> surfaces, const LeadsOut& leads_out) const {
  const std::size_t count = sides_.size();
  Crossed crossed;
  for (const std::uint32_t surface : surfaces) {
    const Side* first = find(surface);
    if (first == nullptr) continue;
    const std::optional<bool> out = leads_out(*first);
    if (!out) return std::nullopt;
    if (!*out) continue;
    crossed.push_back(first);
    if (surfaces.size() == 1) return crossed;
    // Its end that the others share is taken to the other end of the wall opposite.
    const auto at = static_cast<std::size_t>(first - sides_.data());
    const Side& next = sides_[(at + 1) % count];
    const bool at_end = std::ranges::find(surfaces, next.surface) != surfaces.end();
    const Side& second = sides_[(at + count / 2 + (at_end ? count - 1 : 1)) % count];
    const std::optional<bool> too = leads_out(second);
    if (!too) return std::nullopt;
    if (*too) crossed.push_back(&second);
    return crossed;
  }
  return crossed;
}

}  // namespace flatray
