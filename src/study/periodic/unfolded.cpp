#include "study/periodic/unfolded.h"

#include <fmt/core.h>

#include <algorithm>

#include "geom/predicates.h"

namespace flatray {
namespace {

Near signed_by(Sign side, const Near& number) { return side == Sign::negative ? -number : number; }

Proof is_between(const Near& number, const Near& low, const Near& high) {
  return is_positive(number - low) & is_positive(high - number);
}

// Off which side it bounces: that on which orbits are, or of a wall with both any.
Proof is_on_side(const Mirror& mirror, const Near& in, const Near& out) {
  if (mirror.side)
    return is_positive(signed_by(*mirror.side, in)) & is_positive(signed_by(*mirror.side, out));
  return are_opposite(in, -out);
}

// Rows of a matrix of which what is across a ray is changed, and its angle.
struct Transfer {
  Near a{1.0}, b{0.0}, c{0.0}, d{1.0};

  void fly(const Near& length) {
    a = a + length * c;
    b = b + length * d;
  }
  void bend(const Near& power) {
    c = c + power * a;
    d = d + power * b;
  }
};

// Twice the curvature over the cosine, where rays are parted positive: that of the arc alone.
Near power_of(const CurvePlace& place, const Pair<Near>& way, Sign side) {
  const Near speed2 = dot(place.rate, place.rate), bent = cross(place.rate, place.bend);
  const Near across = cross(place.rate, way) / length_of(way);
  const Near power = Near(2) * bent / (speed2 * across);
  const Near size = power.value() < 0 ? -power : power;
  return signed_by(side, size);
}

}  // namespace

std::vector<std::size_t> curved_places(const MirrorRoom& room, const Word& word) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < word.size(); ++i)
    if (room.mirrors[word[i]].arc) places.push_back(i);
  return places;
}

Unfolded unfold(const MirrorRoom& room, const Word& word, const std::vector<std::size_t>& kept) {
  Unfolded made;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    CurvedBounce bounce{&*room.mirrors[word[kept[i]]].arc, {1, 0}, {}, kept[i]};
    Unfolded::Leg leg;
    const std::size_t end = i + 1 < kept.size() ? kept[i + 1] : kept[0] + word.size();
    for (std::size_t k = kept[i] + 1; k < end; ++k) {
      const std::uint8_t number = word[k % word.size()];
      const Mirror& mirror = room.mirrors[number];
      if (mirror.arc) {
        leg.passed.push_back({circle_of(mirror.arc->curve), bounce.next});
        continue;
      }
      bounce.next = bounce.next * reflection_in<Near>(mirror.line);
      leg.straight.push_back(number);
    }
    made.bounces.push_back(bounce);
    made.legs.push_back(std::move(leg));
  }
  return made;
}

void follow_straight(const MirrorRoom& room, const Chord& ends, Pair<Near> way,
                     const Word& straight, Judged& judged) {
  Near left(1.0);
  Chord chord = ends;
  const Surfaces& walls = room.room.walls();
  for (const std::uint8_t number : straight) {
    const Mirror& mirror = room.mirrors[number];
    const auto note = [&](Proof found, const char* words) {
      judged.note(judged.clear, found, fmt::format("{} wall {}", words, number + 1));
    };
    const Pair<Near> a = near(mirror.line.a), along = near(mirror.line.b) - a;
    const Near side = cross(along, chord.from - a), rate = cross(along, way), part = -side / rate;
    note(is_on_side(mirror, side, side), "comes from behind to");
    note(are_opposite(side, side + left * rate), "does not come to");
    chord.to = chord.from + part * way;
    chord.to_surface = mirror.surface;
    note(is_between(dot(chord.to - a, along), 0.0, dot(along, along)), "runs past an end of");
    if (judged.clear == Proof::no) return;
    judged.note(judged.clear, is_free(walls, chord), "a wall is in the way");
    judged.points.push_back(middle(chord.to));
    way = mirrored(along, way);
    left = left - part;
    chord.from = chord.to;
    chord.from_surface = mirror.surface;
  }
  chord.to = ends.to;
  chord.to_surface = ends.to_surface;
  judged.note(judged.clear, is_free(walls, chord), "a wall is in the way");
}

Judged judge(const MirrorRoom& room, const Word& word, const StationaryPolygon& polygon,
             const std::vector<Unfolded::Leg>& legs) {
  Judged judged;
  Transfer transfer;
  const auto& bounces = polygon.bounces();
  for (std::size_t i = 0; i < bounces.size(); ++i) {
    const std::size_t j = polygon.after(i);
    const Mirror& here = room.mirrors[word[bounces[i].place]];
    const Mirror& there = room.mirrors[word[bounces[j].place]];
    const CurvePlace place = polygon.place(i);
    const Pair<Near> way = polygon.way_from(i), from = polygon.way_to(i);
    const bool turned = cross_sign(here.arc->curve.u, here.arc->curve.v) == Sign::negative;
    const Sign rightward = turned ? Sign::negative : Sign::positive;
    const Near out = signed_by(rightward, cross(way, place.rate)),
               in = signed_by(rightward, cross(place.rate, from));
    judged.note(judged.reflects, is_on_side(here, in, out),
                fmt::format("does not reflect off wall {}", word[bounces[i].place] + 1));
    judged.note(judged.clear, lies_on(*here.arc, place.point),
                fmt::format("runs past an end of wall {}", word[bounces[i].place] + 1));
    const Near length = length_of(way);
    judged.length = judged.length + length;
    transfer.bend(power_of(place, way, out.value() < 0 ? Sign::negative : Sign::positive));
    transfer.fly(length);
    if ((judged.reflects & judged.clear) == Proof::no) continue;
    judged.points.push_back(middle(place.point));
    follow_straight(room, {place.point, polygon.place(j).point, here.surface, there.surface}, way,
                    legs[i].straight, judged);
  }
  if (judged.points.size() == word.size())  // the first one is that of the word's first wall
    std::rotate(judged.points.begin(),
                judged.points.end() - static_cast<std::ptrdiff_t>(bounces[0].place),
                judged.points.end());
  const Near trace = transfer.a + transfer.d;
  judged.trace = word.size() % 2 == 0 ? trace : -trace;
  return judged;
}

}  // namespace flatray
