#include "render/monotone_ring.h"

#include <algorithm>
#include <cmath>

namespace flatray {
namespace {

// Changes between down and up along a ring; level edges change nothing.
class Turns {
 public:
  void pass(double from, double to) {
    const int way = (from < to ? 1 : 0) - (to < from ? 1 : 0);
    count_ += way * last_ < 0 ? 1 : 0;
    last_ = way != 0 ? way : last_;
    first_ = first_ != 0 ? first_ : last_;
  }
  int count() const { return count_ + (first_ == last_ ? 0 : 1); }

 private:
  int count_ = 0, first_ = 0, last_ = 0;
};

// By the ends at which the edges of the list follow one another, if they do.
template <Vec2 Segment::*kBegin, Vec2 Segment::*kEnd>
bool append_by(const std::vector<Segment>& edges, std::vector<Corner>& corners) {
  Turns turns;
  double far = 0;
  std::size_t top = 0;
  const Vec2* before = &(edges.back().*kEnd);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Vec2 &from = edges[i].*kBegin, &to = edges[i].*kEnd;
    if (before->x() != from.x() || before->y() != from.y()) return false;
    turns.pass(from.y(), to.y());
    far = std::max(far, std::max(std::abs(from.x()), std::abs(from.y())));
    if (from.y() < (edges[top].*kBegin).y()) top = i;
    before = &to;
  }
  if (turns.count() > 2 || !(far <= kMonotoneReach)) return false;
  const auto append = [&](std::size_t begin, std::size_t end) {
    for (; begin < end; ++begin)
      corners.push_back({(edges[begin].*kBegin).x(), (edges[begin].*kBegin).y()});
  };
  append(top, edges.size());
  append(0, top);
  return true;
}

}  // namespace

bool append_monotone_ring(const FillPath& path, std::size_t most, std::vector<Corner>& corners) {
  const std::vector<Segment>& edges = path.edges;
  if (!path.simple || edges.empty() || edges.size() > most) return false;
  return append_by<&Segment::a, &Segment::b>(edges, corners) ||
         append_by<&Segment::b, &Segment::a>(edges, corners);  // listed against their direction
}

}  // namespace flatray
