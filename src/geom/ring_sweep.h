#pragma once
#include <set>

#include "geom/polygon.h"

namespace flatray {

/// A line that goes over a ring from left to right, at equal x from below, and stops at every
/// vertex (Shamos and Hoey 1976). It keeps in order the edges it meets, and ends where two of them
/// do: what two neighbours do up to the nearer end is one exact predicate.
///
/// Needs   distinct neighbours in `points`, which outlive it; edge i begins at vertex i.
/// Cost    O(n log n).
class RingSweep {
 public:
  using Index = std::uint32_t;
  static constexpr Index kNone = ~Index{0};

  /// What a vertex does to the edges the line meets: its own two start there or end there, the
  /// first below the second, or the first gives way to the second. `below` is the edge next below.
  struct Event {
    enum class Kind { start, pass, end } kind;
    Index vertex, first, second, below;
  };

  explicit RingSweep(std::span<const Vec2> points);
  RingSweep(const RingSweep&) = delete;
  RingSweep& operator=(const RingSweep&) = delete;

  /// The next vertex; nullopt behind the last one and where edges meet.
  std::optional<Event> next();
  /// What it ended at; nullopt for a simple ring.
  const std::optional<CrossingEdges>& crossing() const { return crossing_; }

 private:
  struct Met {
    mutable Index edge;  // one that follows on takes its place
  };
  struct FromBelow {
    using is_transparent = void;
    std::span<const Vec2> points;

    Index after(Index i) const { return i + 1 == points.size() ? 0 : i + 1; }
    const Vec2& left(Index edge) const;
    const Vec2& right(Index edge) const;
    Sign side(Index edge, const Vec2& point) const;  // positive: the point lies above it
    bool operator()(const Met& a, const Met& b) const;
    bool operator()(const Met& a, const Vec2& point) const;
  };
  using Order = std::set<Met, FromBelow>;

  Event start(Index in, Index out);
  Event pass(Index before, Index after);
  Event end(Index in, Index out);
  Index below(Order::iterator edge) const;
  void check(Order::iterator upper);
  void meet(Index a, Index b);

  FromBelow ring_;
  std::vector<Index> vertices_;  // from left to right
  std::size_t at_ = 0;
  Order order_;
  std::vector<Order::iterator> places_;  // of the edges the line meets
  std::optional<CrossingEdges> crossing_;
};

}  // namespace flatray
