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

  void open(const std::vector<ChainLeg>& legs) const {
    const std::vector<ChainLeg> back = backward(legs);
    Ring ring(legs.front().a + side(legs.front().from), edges_);
    right_side(legs, ring);
    cap(legs.back(), ring);
    right_side(back, ring);
    cap(back.back(), ring);
    ring.close();
  }

  void closed(const std::vector<ChainLeg>& legs) const {
    one_side(legs);
    one_side(backward(legs));
  }

  // More than one where a leg turns by more than one chord may.
  int parts_of(const ChainLeg& leg) const {
    if (is_one_chord(leg.from, leg.to, 0.25 * kCapSagitta_px)) return 1;
    const double angle = std::fabs(angle_of(leg.from, leg.to));
    return std::max(1, static_cast<int>(std::ceil(2 * chords_ * angle / kHalfTurn)));
  }
  void add(const ChainLeg& leg, std::vector<ChainLeg>& legs) const {
    const int parts = parts_of(leg);
    if (parts == 1) return legs.push_back(leg);
    const double angle = angle_of(leg.from, leg.to);
    const auto at = [&](double i) -> Vec2 { return leg.a + i / parts * (leg.b - leg.a); };
    for (int i = 0; i < parts; ++i)
      legs.push_back({at(i), i + 1 < parts ? at(i + 1) : leg.b, i > 0 ? legs.back().to : leg.from,
                      i + 1 < parts ? turned(leg.from, angle * (i + 1) / parts) : leg.to,
                      leg.length / parts});
  }

 private:
  static constexpr double kHalfTurn = std::numbers::pi;
  static constexpr double kRoundedUp = 1 + 0x1p-40;  // corners of a regular polygon are alike

  static std::vector<ChainLeg> backward(const std::vector<ChainLeg>& legs) {
    std::vector<ChainLeg> back;
    for (auto leg = legs.rbegin(); leg != legs.rend(); ++leg) back.push_back(leg->back());
    return back;
  }

  // The offset of the right side.
  Vec2 side(const Vec2& ahead) const { return -style_.half_width * left_of(ahead); }

  static double angle_of(const Vec2& from, const Vec2& to) {
    const double turn = cross(from, to);
    const double along = from.dot(to);
    return turn == 0 && along < 0 ? kHalfTurn : portable::atan2(turn, along);
  }
  bool is_one_chord(const Vec2& from, const Vec2& to, double sagitta) const {
    return (side(to) - side(from)).squaredNorm() <= 8 * sagitta * style_.half_width;
  }

  void right_side(const std::vector<ChainLeg>& legs, Ring& ring) const {
    for (std::size_t i = 0; i < legs.size() && edges_.size() <= most_; ++i) {
      go_along(legs[i], ring);
      if (i + 1 < legs.size()) join(legs[i], legs[i + 1], ring);
    }
  }

  void one_side(const std::vector<ChainLeg>& legs) const {
    Ring ring(legs.front().a + side(legs.front().from), edges_);
    right_side(legs, ring);
    join(legs.back(), legs.front(), ring);
    ring.close();
  }

  // Where the right sides of both ends cross, the line is wider than the leg's circle, and what
  // lies beyond the crossing is passed the other way round: it winds as all the rest.
  void go_along(const ChainLeg& leg, Ring& ring) const {
    const Vec2 along = leg.b - leg.a, from = side(leg.from), to = side(leg.to);
    const double turn = cross(from, to), ahead = cross(along, to), behind = cross(along, from);
    if (turn < 0 && turn < std::min(ahead, behind)) {
      const Vec2 crossing = leg.a + std::max(ahead / turn, 0.0) * from;
      for (const Vec2& point : {crossing, Vec2(leg.b + to), Vec2(leg.a + from), crossing})
        ring.go_to(point);
    }
    ring.go_to(leg.b + to);
  }

  // From the right side of one leg to that of the next, round the point they share.
  void join(const ChainLeg& from, const ChainLeg& to, Ring& ring) const {
    if (from.to == to.from) return;
    const double turn = cross(from.to, to.from), along = from.to.dot(to.from);
    const Vec2 &pivot = from.b, begin = side(from.to), end = side(to.from);
    if (turn < 0) {
      // On the inside both sides pass the pivot, unless each leg covers where the other begins.
      const auto straight = [](const ChainLeg& leg) { return leg.from == leg.to ? leg.length : 0; };
      if (!(-turn * style_.half_width <= std::min(straight(from), straight(to)))) ring.go_to(pivot);
    } else if (style_.joins == LineJoin::round) {
      if (!is_one_chord(from.to, to.from, kCapSagitta_px))
        arc(pivot, begin, angle_of(from.to, to.from), ring);
    } else if (style_.joins == LineJoin::miter && along > -1 &&
               2 <= kRoundedUp * style_.miter_limit * style_.miter_limit * (1 + along)) {
      ring.go_to(pivot + (begin + end) / (1 + along));
    }
    ring.go_to(pivot + end);
  }

  void cap(const ChainLeg& leg, Ring& ring) const {
    const Vec2 begin = side(leg.to);
    if (style_.caps == LineCap::round) arc(leg.b, begin, kHalfTurn, ring);
    if (style_.caps == LineCap::square) {
      const Vec2 out = style_.half_width * leg.to;
      ring.go_to(leg.b + begin + out);
      ring.go_to(leg.b - begin + out);
    }
    ring.go_to(leg.b - begin);
  }

  static Vec2 turned(const Vec2& v, double angle) {
    return portable::cos(angle) * v + portable::sin(angle) * left_of(v);
  }

  // The points between the ends of an arc.
  void arc(const Vec2& centre, const Vec2& from, double angle, Ring& ring) const {
    const int chords = static_cast<int>(std::ceil(angle / kHalfTurn * chords_));
    for (int i = 1; i < chords; ++i) ring.go_to(centre + turned(from, angle * i / chords));
  }

  const LineStyle style_;
  const int chords_;
  std::vector<Segment>& edges_;
  const std::uint64_t most_;
};

}  // namespace

std::vector<ChainLeg> legs_of(const Chain& chain) {
  std::vector<ChainLeg> legs;
  const std::size_t count = chain.points.size();
  for (std::size_t i = 0; i + (chain.closed ? 0 : 1) < count; ++i) {
    const Vec2 &a = chain.points[i], &b = chain.points[i + 1 < count ? i + 1 : 0];
    const Vec2 along = b - a;
    const double length = size_of(along);
    const Vec2 ahead = unit(along);
    if (!chain.ahead.empty())
      legs.push_back({a, b, chain.ahead[2 * i], chain.ahead[2 * i + 1], length});
    else if (length > 0)
      legs.push_back({a, b, ahead, ahead, length});
  }
  return legs;
}

bool add_line(const Chain& chain, const LineStyle& style, std::vector<Segment>& edges,
              std::uint64_t most) {
  if (chain.points.empty()) return true;
  const std::uint64_t begin = edges.size();
  const LineOutline outline(style, edges, begin + most);
  const std::vector<ChainLeg> whole = legs_of(chain);
  std::uint64_t parts = 0;
  for (const ChainLeg& leg : whole) parts += static_cast<std::uint64_t>(outline.parts_of(leg));
  if (parts > most / 2) return false;  // each has an edge on either side
  std::vector<ChainLeg> legs;
  legs.reserve(parts);
  for (const ChainLeg& leg : whole) outline.add(leg, legs);
  if (legs.empty()) legs.push_back({chain.points[0], chain.points[0], {1, 0}, {1, 0}, 0});
  if (chain.closed && legs.size() > 1)
    outline.closed(legs);
  else
    outline.open(legs);
  return edges.size() - begin <= most;
}

double line_reach(const LineStyle& style) {
  const double widths = style.joins == LineJoin::miter ? std::max(style.miter_limit, 1.0) : 1.0;
  return 2 * style.half_width * widths;  // square caps reach sqrt(2) half widths
}

}  // namespace flatray
