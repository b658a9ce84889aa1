#include "render/coverage/stroke.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/portable_math.h"

namespace flatray {
namespace {

// Chords of a half circle that keep within the sagitta: r (1 - cos(angle / 2)) <= r angle^2 / 8.
int half_circle_chords(double radius) {
  const double angle = std::sqrt(8 * kCapSagitta_px / radius);
  return static_cast<int>(std::clamp(std::ceil(std::numbers::pi / angle), 4.0, 4096.0));
}

Vec2 left_of(const Vec2& v) { return {-v.y(), v.x()}; }

// A straight part of a chain, and the offset of its right side.
struct Leg {
  Vec2 a, b, ahead, side;
  double length;

  Leg back() const { return {b, a, -ahead, -side, length}; }
};

// One ring of directed edges.
class Ring {
 public:
  Ring(const Vec2& first, std::vector<Segment>& edges)
      : first_(first), last_(first), edges_(edges) {}
  void go_to(const Vec2& point) {
    if (point != last_) edges_.push_back({last_, point});
    last_ = point;
  }
  void close() { go_to(first_); }

 private:
  Vec2 first_, last_;
  std::vector<Segment>& edges_;
};

class LineOutline {
 public:
  LineOutline(const LineStyle& style, std::vector<Segment>& edges, std::uint64_t most)
      : style_(style), chords_(half_circle_chords(style.half_width)), edges_(edges), most_(most) {}

  void open(const std::vector<Leg>& legs) {
    const std::vector<Leg> back = backward(legs);
    Ring ring(legs.front().a + legs.front().side, edges_);
    right_side(legs, ring);
    cap(legs.back(), ring);
    right_side(back, ring);
    cap(back.back(), ring);
    ring.close();
  }

  void closed(const std::vector<Leg>& legs) {
    one_side(legs);
    one_side(backward(legs));
  }

  void dot(const Vec2& point, const Vec2& ahead) {
    if (style_.caps == LineCap::butt) return;
    const Vec2 side = -style_.half_width * left_of(ahead);
    const Leg leg{point, point, ahead, side, 0};
    Ring ring(point + side, edges_);
    cap(leg, ring);
    cap(leg.back(), ring);
    ring.close();
  }

 private:
  static std::vector<Leg> backward(const std::vector<Leg>& legs) {
    std::vector<Leg> back;
    for (auto leg = legs.rbegin(); leg != legs.rend(); ++leg) back.push_back(leg->back());
    return back;
  }

  void right_side(const std::vector<Leg>& legs, Ring& ring) const {
    for (std::size_t i = 0; i < legs.size() && edges_.size() <= most_; ++i) {
      ring.go_to(legs[i].b + legs[i].side);
      if (i + 1 < legs.size()) join(legs[i], legs[i + 1], ring);
    }
  }

  void one_side(const std::vector<Leg>& legs) const {
    Ring ring(legs.front().a + legs.front().side, edges_);
    right_side(legs, ring);
    join(legs.back(), legs.front(), ring);
    ring.close();
  }

  // From the right side of one leg to that of the next, round the point they share.
  void join(const Leg& from, const Leg& to, Ring& ring) const {
    const double turn = cross(from.ahead, to.ahead), along = from.ahead.dot(to.ahead);
    const Vec2& pivot = from.b;
    if (turn < 0) {
      // On the inside both sides pass the pivot, unless each leg covers where the other begins.
      if (!(-turn * style_.half_width <= std::min(from.length, to.length))) ring.go_to(pivot);
    } else if (style_.joins == LineJoin::round) {
      round_join(from, to, turn, along, ring);
    } else if (style_.joins == LineJoin::miter && along > -1 &&
               2 <= style_.miter_limit * style_.miter_limit * (1 + along)) {
      ring.go_to(pivot + (from.side + to.side) / (1 + along));
    }
    ring.go_to(pivot + to.side);
  }

  void round_join(const Leg& from, const Leg& to, double turn, double along, Ring& ring) const {
    if ((to.side - from.side).squaredNorm() <= 8 * kCapSagitta_px * style_.half_width) return;
    const double angle = turn == 0 ? std::numbers::pi : portable::atan2(turn, along);
    const double count = std::ceil(angle / std::numbers::pi * chords_);
    arc(from.b, from.side, angle, static_cast<int>(count), ring);
  }

  void cap(const Leg& leg, Ring& ring) const {
    if (style_.caps == LineCap::round) arc(leg.b, leg.side, std::numbers::pi, chords_, ring);
    if (style_.caps == LineCap::square) {
      const Vec2 out = style_.half_width * leg.ahead;
      ring.go_to(leg.b + leg.side + out);
      ring.go_to(leg.b - leg.side + out);
    }
    ring.go_to(leg.b - leg.side);
  }

  // The points between the ends of an arc.
  static void arc(const Vec2& centre, const Vec2& from, double angle, int chords, Ring& ring) {
    const Vec2 ahead = left_of(from);
    for (int i = 1; i < chords; ++i) {
      const double a = angle * i / chords;
      ring.go_to(centre + portable::cos(a) * from + portable::sin(a) * ahead);
    }
  }

  const LineStyle style_;
  const int chords_;
  std::vector<Segment>& edges_;
  const std::uint64_t most_;
};

}  // namespace

void add_line(const Chain& chain, const LineStyle& style, std::vector<Segment>& edges,
              std::uint64_t most) {
  std::vector<Leg> legs;
  const std::size_t count = chain.points.size();
  for (std::size_t i = 0; i + (chain.closed ? 0 : 1) < count; ++i) {
    const Vec2 &a = chain.points[i], &b = chain.points[i + 1 < count ? i + 1 : 0];
    const Vec2 along = b - a;
    const double length = std::sqrt(along.squaredNorm());
    if (!(length > 0)) continue;
    const Vec2 ahead = along / length;
    legs.push_back({a, b, ahead, -style.half_width * left_of(ahead), length});
  }
  LineOutline outline(style, edges, most);
  if (legs.empty()) {
    if (count > 0) outline.dot(chain.points.front(), chain.ahead);
  } else if (chain.closed && legs.size() > 1) {
    outline.closed(legs);
  } else {
    outline.open(legs);
  }
}

double line_reach(const LineStyle& style) {
  const double widths = style.joins == LineJoin::miter ? std::max(style.miter_limit, 1.0) : 1.0;
  return 2 * style.half_width * widths;  // square caps reach sqrt(2) half widths
}

}  // namespace flatray
