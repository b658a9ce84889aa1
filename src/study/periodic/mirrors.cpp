#include "study/periodic/mirrors.h"

#include <fmt/core.h>

namespace flatray {
namespace {

constexpr std::size_t kMostMirrors = 64;

Pair<Near> form_of(const Ellipse& curve, const Pair<Near>& w) {
  return curve_form([](double x) { return Near(x); }, curve, w);
}

Proof between_ends(const Near& part) { return is_positive(part) & is_positive(Near(1) - part); }

Proof is_met(const Segment& wall, bool from_it, bool to_it, const Chord& chord) {
  const Pair<Near> a = near(wall.a), b = near(wall.b), along = b - a, way = chord.to - chord.from;
  if (from_it || to_it) return Proof::no;  // the bounce there has been found to turn away from it
  return are_opposite(cross(way, a - chord.from), cross(way, b - chord.from)) &
         are_opposite(cross(along, chord.from - a), cross(along, chord.to - a));
}

Proof is_met_at(const Arc& wall, const Chord& chord, const Near& part) {
  const Proof within = between_ends(part);
  if (within == Proof::no) return within;
  return within & lies_on(wall, chord.from + part * (chord.to - chord.from));
}

// The chord meets the curve where a t^2 + 2 b t + c = 0; where it stands on it one root is known.
Proof is_met(const Arc& wall, bool from_it, bool to_it, const Chord& chord) {
  if (from_it && to_it) return Proof::no;
  if (to_it) return is_met(wall, true, false, {chord.to, chord.from});
  const Pair<Near> w = form_of(wall.curve, chord.from - near(wall.curve.centre));
  const Pair<Near> d = form_of(wall.curve, chord.to - chord.from);
  const Near a = dot(d, d), b = dot(w, d);
  if (from_it) return is_met_at(wall, chord, -(Near(2) * b) / a);
  const Near r = form_size([](double x) { return Near(x); }, wall.curve), c = dot(w, w) - r * r;
  const Pair<Near> w2 = w + d;
  const Proof outside = is_positive(c) & is_positive(dot(w2, w2) - r * r);
  if ((outside & (is_positive(b) | is_positive(-b - a))) == Proof::yes) return Proof::no;
  const Near square = b * b - a * c;
  const Proof crossed = is_positive(square);
  if (crossed != Proof::yes) return crossed;
  const Near root = square_root(square);
  return is_met_at(wall, chord, (-b - root) / a) | is_met_at(wall, chord, (root - b) / a);
}

Proof is_met(const Bezier&, bool, bool, const Chord&) { return Proof::open; }

}  // namespace

Result<MirrorRoom> MirrorRoom::of(const Room& room) {
  MirrorRoom made{room, {}};
  const Surfaces& walls = room.walls();
  const Place place = room.scene().where;
  if (!walls.beziers.empty())
    return fail(place, "has Bezier curves, of which no periodic orbits are proven",
                "take segments, arcs, circles and ellipses");
  for (std::uint32_t i = 0; i < walls.size(); ++i) {
    if (room.materials()[i] != Material::mirror) continue;
    Mirror mirror{i, room.inner_side(i)};
    if (walls.segment_slot(i) != kNoSurface)
      mirror.line = walls.segment(i);
    else
      mirror.arc = walls.arc(i);
    made.mirrors.push_back(mirror);
  }
  if (made.mirrors.empty())
    return fail(place, "has no mirrors that orbits could close between",
                "say material = \"mirror\" of its entities");
  if (made.mirrors.size() > kMostMirrors)
    return fail(place,
                fmt::format("has {} mirrors, and words of at most {} are counted",
                            made.mirrors.size(), kMostMirrors),
                "take a scene with fewer walls");
  return made;
}

std::string MirrorRoom::text(const Word& word) const {
  std::string all;
  for (const std::uint8_t one : word)
    all += (all.empty() || mirrors.size() < 10 ? "" : ".") + std::to_string(one + 1);
  return all;
}

Proof lies_on(const Arc& arc, const Pair<Near>& point) {
  if (arc.extent == Arc::Extent::whole) return Proof::yes;
  bool known = true;
  const PlaceOn place = place_in_cone(arc, [&](const Vec2& p, const Vec2& a, const Vec2& b) {
    const auto sign = cross(near(b) - near(a), point - near(p)).sign();
    known = known && sign.has_value();
    return sign.value_or(Sign::zero);
  });
  if (!known || place == PlaceOn::at_end) return Proof::open;
  return place == PlaceOn::inner ? Proof::yes : Proof::no;
}

Proof is_met(const Surfaces& walls, std::uint32_t surface, const Chord& chord) {
  return walls.visit(surface, [&](const auto& wall) {
    return is_met(wall, chord.from_surface == surface, chord.to_surface == surface, chord);
  });
}

Proof is_free(const Surfaces& walls, const Chord& chord) {
  Proof free = Proof::yes;
  for (std::uint32_t i = 0; i < walls.size() && free != Proof::no; ++i)
    free = free & !is_met(walls, i, chord);
  return free;
}

}  // namespace flatray
