#include <algorithm>

#include "geom/exact.h"
#include "study/periodic/closed_orbits.h"

namespace flatray {
namespace {

using Vector = Pair<Rational>;

constexpr int kMostCuts = 10;

bool is_null(const Vector& v) { return v.x.sign() == Sign::zero && v.y.sign() == Sign::zero; }

Near near(const Rational& number) {
  const double nearest = number.nearest();
  return Near::within(nearest, kDoubleError * std::fabs(nearest) + kUnderflowError);
}
Pair<Near> near(const Vector& v) { return {near(v.x), near(v.y)}; }

// Of orbits that start on the first wall, in the part `low` to `high` of it.
struct Strip {
  Vector way;
  Rational low = 0.0, high = 1.0;
  std::string why{};  // there is none

  // What must be positive is linear in the part.
  void expect(const Rational& at_low, const Rational& at_high, const char* words) {
    if (!why.empty()) return;
    if (at_low.sign() != Sign::positive && at_high.sign() != Sign::positive) why = words;
    if (at_low.sign() == at_high.sign()) return;
    const Rational cut = at_low / (at_low - at_high);
    if (at_low.sign() == Sign::positive)
      high = std::min(high, cut);
    else
      low = std::max(low, cut);
  }
};

// The way that leads once around, after which it is the same again.
std::optional<Vector> way_around(const Isometry<Rational>& around, bool turned) {
  const auto& [x, y, shift] = around;
  if (!turned) {
    const Vector off{x.x - Rational(1), x.y};
    if (!is_null(off) || is_null(shift)) return std::nullopt;
    return shift;
  }
  Vector axis{Rational(1) + x.x, x.y};
  if (is_null(axis)) axis = {0.0, 1.0};
  const Rational share = dot(shift, axis) / dot(axis, axis);
  if (share.sign() == Sign::zero) return std::nullopt;
  return share * axis;
}

Isometry<Rational> image_by(const MirrorRoom& room, const Word& straight) {
  Isometry<Rational> all;
  for (const std::uint8_t number : straight)
    all = all * reflection_in<Rational>(room.mirrors[number].line);
  return all;
}

Vector end_of(const Segment& wall, bool second) {
  const Vec2& end = second ? wall.b : wall.a;
  return {end.x(), end.y()};
}

// Where orbits from both ends of the first wall meet the lines of the others, and it again.
void follow(const MirrorRoom& room, const Word& word, Strip& strip) {
  const Segment& first = room.mirrors[word[0]].line;
  Vector at[2] = {end_of(first, false), end_of(first, true)}, way = strip.way;
  for (std::size_t k = 1; k <= word.size() && strip.why.empty(); ++k) {
    const Mirror& mirror = room.mirrors[word[k % word.size()]];
    const Vector a = end_of(mirror.line, false), along = end_of(mirror.line, true) - a;
    const Rational rate = cross(along, way);
    if (rate.sign() == Sign::zero) strip.why = "runs along a wall";
    if (mirror.side && rate.sign() == *mirror.side) strip.why = "comes to a wall from behind";
    if (!strip.why.empty()) return;
    if (k < word.size()) {
      Rational part[2], place[2];
      for (const int end : {0, 1}) {
        part[end] = -cross(along, at[end] - a) / rate;
        at[end] = at[end] + part[end] * way;
        place[end] = dot(at[end] - a, along) / dot(along, along);
      }
      strip.expect(part[0], part[1], "comes to its walls in another order");
      strip.expect(place[0], place[1], "runs past an end of a wall");
      strip.expect(Rational(1) - place[0], Rational(1) - place[1], "runs past an end of a wall");
    }
    way = mirrored(along, way);
  }
}

// Of orbits that begin within half of an interval about a part of the first wall.
Judged judge_part(const MirrorRoom& room, const Word& word, const Strip& strip, const Near& part) {
  const Mirror& first = room.mirrors[word[0]];
  const Pair<Near> a = near(end_of(first.line, false)), b = near(end_of(first.line, true));
  const Pair<Near> start = a + part * (b - a);
  Judged judged;
  judged.points.emplace_back(start.x.value(), start.y.value());
  follow_straight(room, {start, start, first.surface, first.surface}, near(strip.way),
                  Word(word.begin() + 1, word.end()), judged);
  return judged;
}

// Whether any orbit of the strip is free: by ever smaller parts of it, until one is or none may be.
Judged free_part(const MirrorRoom& room, const Word& word, const Strip& strip) {
  const double low = strip.low.nearest(), high = strip.high.nearest();
  Judged judged;
  for (int cuts = 0; cuts <= kMostCuts; ++cuts) {
    Proof any = Proof::no;
    for (int i = 0; i < 1 << cuts; ++i) {
      const double half = (high - low) / (2 << cuts);
      judged = judge_part(room, word, strip, Near::within(low + (2 * i + 1) * half, half));
      if (judged.clear == Proof::yes) return judged;
      any = any | judged.clear;
    }
    judged.clear = any;
    if (any == Proof::no) break;
  }
  return judged;
}

}  // namespace

std::optional<ReturningLine> returning_line(const MirrorRoom& room, const Word& straight) {
  const Isometry<Rational> image = image_by(room, straight);
  const bool turned = straight.size() % 2 == 1;
  const auto way = way_around(image, turned);
  if (!way) return std::nullopt;
  ReturningLine line{near(*way), std::nullopt};
  if (turned) line.through = near(Vector{image.shift.x / Rational(2), image.shift.y / Rational(2)});
  return line;
}

bool have_same_image(const MirrorRoom& room, const Word& straight, const Word& other) {
  const Isometry<Rational> one = image_by(room, straight), two = image_by(room, other);
  const auto same = [](const Vector& a, const Vector& b) { return is_null(a - b); };
  return same(one.x, two.x) && same(one.y, two.y) && same(one.shift, two.shift);
}

ClosedOrbit straight_orbit(const MirrorRoom& room, const Word& word) {
  ClosedOrbit orbit{word, Verdict::pruned};
  Word from_second = word;
  std::rotate(from_second.begin(), from_second.begin() + 1, from_second.end());
  const Isometry<Rational> around = image_by(room, from_second);
  const bool turned = word.size() % 2 == 1;
  const auto way = way_around(around, turned);
  orbit.why = "its walls turn every line";
  if (!way) return orbit;
  Strip strip{*way};
  follow(room, word, strip);
  Judged judged;
  if (strip.why.empty() && !(strip.low < strip.high)) strip.why = "runs past an end of a wall";
  if (strip.why.empty() && turned) {
    const Segment& first = room.mirrors[word[0]].line;
    const Vector a = end_of(first, false), along = end_of(first, true) - a;
    const Rational two(2);
    const Vector axis{around.shift.x / two - a.x, around.shift.y / two - a.y};
    const Rational part = cross(axis, *way) / cross(along, *way);
    if (part <= strip.low || part >= strip.high)
      strip.why = "runs past an end of a wall";
    else
      judged = judge_part(room, word, strip, near(part));
  } else if (strip.why.empty()) {
    judged = free_part(room, word, strip);
  }
  orbit.why = strip.why.empty() ? judged.why : strip.why;
  if (!strip.why.empty() || judged.clear == Proof::no) return orbit;
  orbit.verdict = judged.clear == Proof::open ? Verdict::undecided
                  : turned                    ? Verdict::proven
                                              : Verdict::family;
  if (!orbit.is_there()) return orbit;
  orbit.why.clear();
  orbit.length = length_of(near(*way));
  orbit.trace = turned ? -2.0 : 2.0;
  orbit.points = judged.points;
  return orbit;
}

}  // namespace flatray
