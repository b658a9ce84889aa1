#include "geom/triangulate.h"

#include <deque>

#include "base/check.h"
#include "geom/predicates.h"

namespace flatray {
namespace {

using Index = std::uint32_t;

// The polygon that is left, as a ring of corners. Only a reflex or flat corner can keep another
// from being an ear, and cutting an ear changes that for its two neighbours alone: so there are at
// most 3 tests a corner.
class EarCutter {
 public:
  EarCutter(std::span<const Vec2> points, std::span<const Index> corners)
      : points_(points), corners_(points.size()), left_(corners.size()), last_(corners[0]) {
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Index a = corners[k], b = corners[k + 1 == corners.size() ? 0 : k + 1];
      corners_[a].next = b;
      corners_[b].before = a;
    }
    for (const Index i : corners)
      if (!is_convex(i)) reflex_.push_back(i);
    for (const Index i : corners) update(i);
  }

  std::vector<HalfEdge> cut() {
    while (left_ > 3) {
      FLATRAY_CHECK(!ears_.empty(), "the ring is not simple");  // a simple polygon has two
      const Index ear = ears_.front();
      ears_.pop_front();
      if (corners_[ear].gone || !corners_[ear].is_ear) continue;
      last_ = corners_[ear].before;
      add_triangle(last_, ear, corners_[ear].next);
      remove(ear);
    }
    close();
    return std::move(sides_);
  }

 private:
  struct Corner {
    Index next = 0, before = 0;
    Index across = kNoTwin;  // the half-edge beyond the side to `next`
    bool gone = false, is_ear = false;
  };

  bool is_convex(Index i) const {
    return orientation(points_[corners_[i].before], points_[i], points_[corners_[i].next]) ==
           Sign::positive;
  }

  // Whether a closed triangle holds a point.
  bool holds(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& p) const {
    return orientation(c, a, p) != Sign::negative && orientation(a, b, p) != Sign::negative &&
           orientation(b, c, p) != Sign::negative;
  }

  bool is_ear(Index i) {
    if (!is_convex(i)) return false;
    const Index before = corners_[i].before, next = corners_[i].next;
    const Vec2 &a = points_[before], &b = points_[i], &c = points_[next];
    const Vec2 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    for (const Index r : reflex_) {
      const Vec2& p = points_[r];
      if (p.x() < low.x() || p.x() > high.x() || p.y() < low.y() || p.y() > high.y()) continue;
      if (r != before && r != next && holds(a, b, c, p)) return false;
    }
    return true;
  }

  void update(Index i) {
    corners_[i].is_ear = is_ear(i);
    if (corners_[i].is_ear) ears_.push_back(i);
  }

  void remove(Index ear) {
    const Index a = corners_[ear].before, b = corners_[ear].next;
    corners_[ear].gone = true;
    corners_[a].next = b;
    corners_[b].before = a;
    --left_;
    // A corner that is cut off was convex; its neighbours can only have become so.
    std::erase_if(reflex_, [&](Index r) { return (r == a || r == b) && is_convex(r); });
    update(a);
    update(b);
  }

  Index add_side(Index from) {
    const Index side = static_cast<Index>(sides_.size()), twin = corners_[from].across;
    sides_.push_back({from, twin});
    if (twin != kNoTwin) sides_[twin].twin = side;
    return side;
  }

  // The ear at b; its third side becomes a side of what is left.
  void add_triangle(Index a, Index b, Index c) {
    add_side(a);
    add_side(b);
    corners_[a].across = static_cast<Index>(sides_.size());
    sides_.push_back({c, kNoTwin});
  }

  void close() {
    for (Index i = last_, k = 0; k < 3; ++k, i = corners_[i].next) add_side(i);
  }

  std::span<const Vec2> points_;
  std::vector<Corner> corners_;
  std::vector<Index> reflex_;
  std::deque<Index> ears_;
  std::vector<HalfEdge> sides_;
  std::size_t left_;
  Index last_;  // a corner that is still there
};

}  // namespace

std::vector<HalfEdge> triangulate(std::span<const Vec2> points,
                                  std::span<const std::uint32_t> corners) {
  return EarCutter(points, corners).cut();
}

}  // namespace flatray
