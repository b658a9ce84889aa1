#pragma once
#include <cstdint>
#include <vector>

#include "geom/primitives/wall.h"

namespace flatray {

/// No surface: a ray that hits nothing, or has left none.
inline constexpr std::uint32_t kNoSurface = 0xffffffffU;

/// Walls in flat arrays, one for each kind of primitive (geom/primitives/wall.h). A surface is a
/// wall by its number, a slot its place in the array of its kind.
struct Surfaces {
  std::vector<Segment> segments;
  std::vector<Arc> arcs;  ///< circles and ellipses, whole or parts of them
  std::vector<Bezier> beziers;
  std::vector<std::uint32_t> segment_numbers;  ///< the surface in each slot, ascending
  std::vector<std::uint32_t> curve_numbers;    ///< the surfaces that are no segments, ascending

  std::size_t size() const { return slots_.size(); }
  /// Puts a wall at the end and gives its number. Needs finite coordinates, radius >= 0, and
  /// what Arc and Bezier need.
  std::uint32_t add(const Segment& wall);
  std::uint32_t add(const Arc& wall);
  std::uint32_t add(const Bezier& wall);
  std::uint32_t add(const Circle& wall) {
    return add(Arc{wall, Arc::Extent::whole, {0, 0}, {0, 0}});
  }

  /// Calls `use` with a wall as the primitive that it is, and gives what `use` gives.
  template <class Use>
  decltype(auto) visit(std::uint32_t surface, const Use& use) const {
    const std::uint32_t slot = slots_[surface];
    if (slot < kCurved) return use(segments[slot]);
    return slot < kBezier ? use(arcs[slot - kCurved]) : use(beziers[slot - kBezier]);
  }
  /// The same of a segment or an arc. Callers know that it is one, as scene/moving_mirrors.cpp
  /// says; of another it throws std::out_of_range.
  template <class Use>
  decltype(auto) visit_line_or_arc(std::uint32_t surface, const Use& use) const {
    const std::uint32_t slot = slots_[surface];
    return slot < kCurved ? use(segments[slot]) : use(arcs.at(slot - kCurved));
  }
  /// The slot of a wall that is a segment; else kNoSurface.
  std::uint32_t segment_slot(std::uint32_t surface) const {
    return surface != kNoSurface && slots_[surface] < kCurved ? slots_[surface] : kNoSurface;
  }
  /// A wall that is an arc; else nullptr.
  const Arc* arc_at(std::uint32_t surface) const {
    const std::uint32_t slot = slots_[surface];
    return slot >= kCurved && slot < kBezier ? &arcs[slot - kCurved] : nullptr;
  }
  /// A wall known to be a segment.
  const Segment& segment(std::uint32_t surface) const { return segments[slots_[surface]]; }
  /// A wall known to be an arc.
  const Arc& arc(std::uint32_t surface) const { return arcs[slots_[surface] - kCurved]; }

 private:
  template <class Wall>
  std::uint32_t put(const Wall& wall, std::vector<Wall>& kind, std::uint32_t which,
                    std::vector<std::uint32_t>& numbers);

  static constexpr std::uint32_t kCurved = 0x80000000U, kBezier = 0xc0000000U;
  std::vector<std::uint32_t> slots_;  // in the array of its kind, and which array
};

/// A box that holds all walls.
Bounds bounds_of(const Surfaces& walls);

}  // namespace flatray
