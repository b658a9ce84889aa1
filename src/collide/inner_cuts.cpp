#include "collide/inner_cuts.h"

#include <algorithm>
#include <array>

#include "geom/polygon.h"

namespace flatray {
namespace {

// Along a line: the order of its points.
bool comes_before(const Vec2& p, const Vec2& q) {
  return p.x() < q.x() || (p.x() == q.x() && p.y() < q.y());
}

bool has_no_area(const ShapePart& part) {
  return !part.curve && part.radius == 0 && ring_orientation(part.ring) == Sign::zero;
}

class CutAgainstPart {
 public:
  CutAgainstPart(const Vec2& from, const Vec2& to, const Vec2& velocity, const ShapePart& part,
                 const Vec2& part_velocity)
      : cut_{from, to}, velocity_(velocity), part_(part), part_velocity_(part_velocity) {
    if (comes_before(to, from)) std::swap(cut_[0], cut_[1]);
  }

  void tell(Range within, std::vector<MeetingPart>& met) const {
    if (!on_one_line()) return;
    const auto [low, high] =
        std::minmax_element(part_.ring.begin(), part_.ring.end(), comes_before);
    if (within.low <= 0 && within.high >= 0 && comes_before(*low, cut_[1]) &&
        comes_before(cut_[0], *high))
      raise(0, StartPlace::inside, met);
    if (velocity_ == part_velocity_ ||
        cross_sign(velocity_, part_velocity_, cut_[0], cut_[1]) != Sign::zero)
      return;
    // On that line at all times: for a while on the cut, or only at one of its ends.
    const HitInterval times =
        contact({cut_, velocity_}, {part_.ring, part_velocity_}, within).times;
    if (times.kind == HitClass::along) raise(times.t_enter, StartPlace::outside, met);
  }

 private:
  bool on_one_line() const {
    return std::all_of(part_.ring.begin(), part_.ring.end(), [&](const Vec2& p) {
      return orientation(cut_[0], cut_[1], p) == Sign::zero;
    });
  }
  static void raise(double time, StartPlace start, std::vector<MeetingPart>& met) {
    for (MeetingPart& part : met) {
      if (time < part.times.low || time > part.times.high) continue;
      part.kind = HitClass::through;
      part.start = std::max(part.start, start);
    }
  }

  std::array<Vec2, 2> cut_;  // in the order of its line
  const Vec2& velocity_;
  const ShapePart& part_;
  const Vec2& part_velocity_;
};

void count_cuts(const MovingParts& cut, const MovingParts& other, Range within,
                std::vector<MeetingPart>& met) {
  if (std::all_of(cut.parts.begin(), cut.parts.end(),
                  [](const ShapePart& piece) { return piece.cuts.empty(); }))
    return;
  for (const ShapePart& part : other.parts) {
    if (!has_no_area(part)) continue;
    for (const ShapePart& piece : cut.parts)
      for (const std::uint32_t k : piece.cuts)
        CutAgainstPart(piece.ring[k], piece.ring[k + 1 == piece.ring.size() ? 0 : k + 1],
                       cut.velocity, part, other.velocity)
            .tell(within, met);
  }
}

}  // namespace

void count_cuts_as_inside(const MovingParts& a, const MovingParts& b, Range within,
                          std::vector<MeetingPart>& met) {
  if (met.empty()) return;
  count_cuts(a, b, within, met);
  count_cuts(b, a, within, met);
}

}  // namespace flatray
